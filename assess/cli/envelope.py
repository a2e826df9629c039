"""`assess envelope`: overturning envelopes, and the critical mechanism for each frequency."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

from assess.cli.options import Jobs, ProjectPath, flag, folder_option, refuse_both


def envelope(
    project: ProjectPath,
    output: Annotated[
        Path | None, folder_option("Folder to write envelopes.pdf, .html and .json, tables and figures to.")
    ] = None,
    as_json: Annotated[bool, flag("--json", "Print envelopes and critical mechanisms as in results.json.")] = False,
    as_csv: Annotated[bool, flag("--csv", "Print the lower bounds as CSV at full precision.")] = False,
    jobs: Jobs = None,
) -> None:
    """Find the ground pulses that overturn each mechanism, and the critical mechanism at each frequency.

    The pulses are those of [analysis.pulses], by default sines from 0.2 to 10 Hz and up to 3 g. No spectrum is needed.
    Prints tables; files are written only with -o. Sweeps are ignored: the envelopes use the values in the project file.
    """
    refuse_both(as_json=as_json, as_csv=as_csv)
    from assess.project.schema import load

    loaded = load(project)
    from assess.cli.interruption import NOTHING_WRITTEN, on_interruption
    from assess.cli.optional_folder import optional_folder
    from assess.cli.progress import progress
    from assess.cli.stderr import print_messages
    from assess.cli.tables.envelopes import csv_text, json_text, table_text
    from assess.outputs.manifest import ENVELOPES
    from assess.project.build import build
    from assess.results.json import dumps
    from assess.study.envelope_run import envelope as envelope_of_study
    from assess.workers import available_cores, process_pool

    wanted = (ENVELOPES, "envelopes.pdf", "envelopes.html", "tables.xlsx")
    place = optional_folder(output, command="assess envelope", owner=ENVELOPES, wanted=wanted)
    with place as stage, on_interruption(NOTHING_WRITTEN), progress() as shown:
        with process_pool(jobs) as executor:
            study = build(loaded, executor=executor)
        results = envelope_of_study(study, jobs=jobs or available_cores(), progress=shown.count)
        if stage is not None:
            from reports.assessment import envelope_report
            from reports.writing import write_document

            (stage / ENVELOPES).write_bytes(dumps(results).encode())
            write_document(envelope_report(results), stage, name="envelopes.pdf", jobs=jobs or 0, progress=shown.step)
    if as_json or as_csv:  # the table includes them
        print_messages(results.warnings)
    print((json_text if as_json else csv_text if as_csv else table_text)(results), end="")
    if output is not None and not (as_json or as_csv):
        print(output / "envelopes.pdf")
