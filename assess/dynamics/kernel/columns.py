"""The columns of the arrays that callers pass to the kernel and of those that it fills."""

# columns of `branch` [2, 6], one row for each side
THRESHOLD, BOUNCE, PARTNER, RATE, LIMIT, TAIL_LIMIT = range(6)
# columns of `found` [jobs, FOUND]; LARGEST (y) and WHEN have two, one for each side
LARGEST, WHEN, IMPACTS, OVERTURNED, PASSED, UPLIFTED, FOUND = 0, 2, 4, 5, 6, 7, 8
# columns of `events` [capacity + 1, 4], whose first entry is the count: time [s], kind, y of a peak or y' before an
# impact, side
HAPPENED, KIND, VALUE, ON = range(4)
PEAK, IMPACT, UPLIFT = range(3)
# columns of `table` [segments, 11]: ends of the segment, the cubics of r and b, highest power first, and the potential
# at its start
LEFT, RIGHT, R3, R2, R1, R0, B3, B2, B1, B0, STORED = range(11)
# columns of `blocks` [n, 2] of a record, one row for every BLOCK intervals: least and largest acceleration
BLOCK, LOWEST, HIGHEST = 32, 0, 1
