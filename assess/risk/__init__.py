"""Statistics of fragility and risk on plain arrays: no mechanism, record or study is known here.

Intensities have any one unit, which medians and hazards share; probabilities are numbers in [0, 1], rates in 1/year.
"""
