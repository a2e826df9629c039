"""The verdict: one deciding answer for each mechanism and limit state, by the basis that the project names.

verdict(question, mechanisms) -> Verdict      a pure function that knows no formulas

question.py          what the project asks of its basis, and what it states about the site's action
methods.py           which limit states decide, and by which methods
target.py            what the index is compared with
answer.py            the deciding answer of one limit state of one mechanism
missing_keys.py      the keys that would answer a check which is not answered
decision.py          mechanisms and the building; the types of what is decided
deciding_checks.py   the checks that decide, marked as such
"""

from assess.codes.verdict.answer import Answer, Index, grade
from assess.codes.verdict.deciding_checks import find_deciding_check, mark_deciding
from assess.codes.verdict.decision import MechanismVerdict, Verdict, verdict
from assess.codes.verdict.methods import find_limit_states, methods_of
from assess.codes.verdict.outcome import Decision, worst
from assess.codes.verdict.question import Action, MechanismChecks, Missing, Question
from assess.codes.verdict.target import target_of

__all__ = [
    "Action",
    "Answer",
    "Decision",
    "Index",
    "MechanismChecks",
    "MechanismVerdict",
    "Missing",
    "Question",
    "Verdict",
    "find_deciding_check",
    "find_limit_states",
    "grade",
    "mark_deciding",
    "methods_of",
    "target_of",
    "verdict",
    "worst",
]
