"""The page in the browser: a building, its mechanisms and what decides, served to this machine alone.

It shows what the program finds and holds no engineering. Only `assess.page.server` knows the library that draws it.
"""
