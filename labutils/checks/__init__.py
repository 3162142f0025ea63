"""Check an exercise where it is written, and say which mistake was made.

    check("process_depth", process_depth)

Needs NumPy and OpenCV only, so it also runs in the browser; exercises that need MuJoCo say so
where it is missing. What is known of an exercise lies in frozen tables of outputs: no solution.
"""

from labutils.checks.judging import judge, judge_answers
from labutils.checks.keeping import check, hint
from labutils.checks.report import Report, report
from labutils.checks.verdict import Verdict

__all__ = ["Report", "Verdict", "check", "hint", "judge", "judge_answers", "report"]
