"""The English text of messages on records, their suites, amplification and spectra, by key."""

from __future__ import annotations

from collections.abc import Mapping

RECORD_TEXTS: Mapping[str, str] = {
    # files and flatfiles
    "file-not-read": "{file} not read: {why}",
    "files-not-read": "further files that could not be read: {number}",
    "cell-ignored": 'row {row}, {column}: "{value}": impossible value; ignored',
    "cells-ignored": "further cells ignored: {number}",
    "flatfile-columns-missing": "the flatfile has no column of {keys} under a name that is known, and the records' own "
    "files are believed there; is its header misspelt? Known are, however they are spaced: {known}",
    "flatfile-no-records": "no row of the flatfile fits, for there is no record that can be read",
    "flatfile-rows-absent": "of {total} records {count} have no row in the flatfile, like {file}; event, magnitude, "
    "distance and Vs30 are those of their own files, where they state them; was a row lost?",
    "flatfile-other-numbers": "no row of the flatfile fits: the files have NGA numbers {first} to {last}, the table "
    "{first_row} to {last_row}; it may be of another search or another NGA project",
    "flatfile-no-numbers": "no row of the flatfile fits: rows are found by the NGA number in a file's name or by the "
    "file's name, and {file} has neither; keep the names that files had when downloaded, like {example}",
    # a record
    "of-record": "{record}: {what}",
    "of-further-records": "further remarks of this kind on records: {number}",
    "peak-large": "its peak is {peak}, above {limit}, as hardly any earthquake reaches; check the unit",
    "peak-large-in-unit": "its peak is {peak}, above {limit}, as hardly any earthquake reaches; check the unit (read "
    "in {unit}; in {likely} it would be {meant})",
    "peak-small": "its peak is {peak}, below {limit}; check the unit",
    "peak-small-in-unit": "its peak is {peak}, below {limit}; check the unit (read in {unit}; in {likely} it would be "
    "{meant})",
    "step-fine": "a step of {step} is finer than instruments of its network have; check the step",
    "step-slow": "with a step of {step} its motion stays below {frequency}, slower than earthquakes; check the step",
    "step-fast": "with a step of {step} half of it is above {frequency}, faster than earthquakes; check the step",
    "step-other": "its step is {step}, that of {other}, of the same station and earthquake, {other_step}; check the "
    "steps",
    "impossible-in-header": "{what} is {value} in its header, which cannot be; the header is damaged",
    "peak-time": "its peak comes {after} after the earthquake's origin at {distance}, where it can come after "
    "{earliest} to {latest}; check the step and the times",
    "header-disagrees": "its {name} is {value}, but its {other_name} is {other}; one of them may be damaged",
    "velocities-disagree": "the velocities of {name} are not the integral of its accelerations",
    "columns-uneven": "the columns of line {line} are not those of the others; characters may be lost",
    "filter-above": "its filter ends at {corner}, but its motion does not with a step of {step}; check the step",
    "filter-below": "its filter begins at {corner}, its motion below that with a step of {step}; check the step",
    "filter-beyond-step": "its filter ends at {corner}, its step of {step} holds {most} at most; check the step",
    # how a record was read and processed
    "read-from": "read from {format}, unit {unit}",
    "read-from-given": "read from {format}, unit {unit} as given, for the file does not say",
    "read-from-by-format": "read from {format}, unit {unit} by the format",
    "read-from-volume": "read from {format} volume {volume}, unit {unit}",
    "read-from-event": "read from {format}, unit {unit}, event of {date}",
    "read-from-response": "read from {format}, response of {file}",
    "before-reading": "before that: {trail}",
    "uncorrected": "uncorrected",
    "mean-removed": "mean taken off",
    "mean-removed-of": "mean of {mean} {unit} taken off",
    "filtered-by-source": "filtered by the source: {low} to {high}",
    "filtered-by-source-from": "filtered by the source: from {low}",
    "filtered-by-source-as": "filtered by the source: {corners} Hz",
    "scaled-by": "scaled by {factor}",
    "baseline-removed": "baseline of degree {degree} taken off",
    "band-filtered": "acausal Butterworth of order {order}, {low} to {high}",
    "high-passed": "acausal Butterworth of order {order}, from {low}",
    "low-passed": "acausal Butterworth of order {order}, up to {high}",
    "resampled": "resampled from {before} to {after}",
    "trimmed": "trimmed to {start}-{end} of its Arias intensity, {first} to {last}",
    "turned": 'turned with component "{component}" of "{record}": {name}',
    "turned-to": 'turned with component "{component}" of "{record}": {name}, azimuth {azimuth}',
    "through-first-mode": "through a first mode of {frequency}, damping {damping}, to where it counts {shape}",
    "suite-raised": "the suite raised by {factor}, with which its mean meets ASCE 43-05, 2.4, to {period}",
    "pulse": "{shape} pulse, {frequency}, {amplitude}",
    "artificial-phases": "artificial: random phases, seed {seed}, number {number}; envelope of Jennings, Housner & "
    "Tsai (1968), {rise} rising, {level} stationary, falling to {duration}",
    "artificial-fit": "5 % spectrum fitted to {code} over {first} to {last}: {low} to {high}, rms {rms}; peak "
    "acceleration that of the target",
    "artificial-baseline": "baseline corrected: velocity and displacement end at zero, mean displacement zero",
    # a locked suite
    "suite-locked": "records and scale factors are those of {file}; {keys} of [records] say how it is made, and count "
    "when `assess records select PROJECT --lock` is run again",
    "lock-edited": "{file} was changed by hand since it was written; its records and factors are used as they are",
    # steps that are too coarse
    "coarse-record": "the time step of {records} is too coarse for {motion}: motion between two samples is lost; "
    "use records with a step of {longest} or less",
    "motion-elastic": "its elastic vibration on the joints, {frequency}",
    "motion-rocking": "its rocking, p = {p}",
    # spectra
    "implausible-site": "{name} = {value} is beyond any plausible site, {most}; is it in another unit?",
    "mapped-exchanged": "S_1 = {s_1} is above S_S = {s_s}, which no map has; are they exchanged?",
    "site-factors-capped": "Z R = {z} × {r} = {product} is taken as {most}, the most that NZS 1170.5, 3.1.1 asks for; "
    "check z and r",
    "study-of-class-e": "ASCE 7-16 §11.4.8 asks for a ground motion hazard analysis for site class E with S_S >= 1.0 "
    "g; F_a is that of class C by its exception 1",
    "study-of-classes-d-and-e": "ASCE 7-16 §11.4.8 asks for a ground motion hazard analysis for site classes D and E "
    "with S_1 >= 0.2 g; the spectrum by Table 11.4-2 can be low at long periods (Supplement 3 raises S_M1 of class D "
    'by half); give that of the study with code = "table"',
    # suites of records
    "remedy-keys": "give {keys}",
    "remedy-records": "give {number} more records",
    "remedy-longer": "records must last {duration}",
    "remedy-finer": "give artificial records at {step} or less",
    "remedy-factor": "scale every record by {factor}",
    "suite-empty": "there are no records: {remedy}",
    "suite-not-named": "artificial records may decide only if [verdict] procedures lists {procedure}: {remedy}",
    "suite-count": "{code} requires {limit} records, {found} are available: {remedy}",
    "suite-step": "{code} {clause} requires a time step of at most {limit}, the longest is {found}: {remedy}",
    "suite-duration": "{code} {clause} requires a duration of {limit}, the shortest record lasts {found}: {remedy}",
    "suite-stationary": "{code} {clause} requires a stationary part of {limit}, the shortest lasts {found}: {remedy}",
    "suite-usable": "{code}: the slowest mechanism has a period of {limit}, the records are usable up to {found}: "
    "{remedy}",
    "suite-mean-low": "{code} {clause}: between {low} and {high} the mean spectrum falls to {found} of the target, "
    "at least {limit} is required: {remedy}",
    "suite-mean-high": "{code} {clause}: between {low} and {high} the mean spectrum rises to {found} of the target, "
    "at most {limit} is allowed: {remedy}",
    "suite-run-below": "{code} {clause}: between {low} and {high} the mean spectrum is below the target at {found} "
    "consecutive periods (a hundred per decade), at most {limit} are allowed: {remedy}",
    "suite-out-of-reach": "{code} {clause} covers the mean spectrum from {low} to {high}, but the comparison ends "
    "at {end}: {remedy}",
    "artificial-records": "artificial records match the spectrum at every period at once, as no earthquake does; "
    "prefer recorded motions",
    "vertical-left-out": "vertical components are not used: {records}",
    # remarks on requirements
    "further-factor": "a further factor of {factor} on every record would do",
    "target-known": "the target is known from {low} to {high} only",
    # amplification
    "by-floor-factor": "every record and pulse is multiplied by {factor}, at h = {height} of H = {building}, "
    "according to {clause}",
    "clause-3-49": "thesis 3.49: S [3 (1 + h/H) - 0.5], S = {soil}",
    "by-rayleigh": "Rayleigh's method on {slices} slices of its bodies: {assumptions}",
    "by-first-mode": "first mode at {frequency} ({frequency_from}), h_e = {effective} ({effective_from}), damping "
    "{damping}, linear mode shape: at h = {height} participation factor times mode shape h/h_e = {shape}",
}
