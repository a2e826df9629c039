"""The bases of a verdict, one file for each code: which limit states decide, by which methods, on which premises."""

from __future__ import annotations

from collections.abc import Mapping

from assess.codes.bases.asce41_13 import ASCE41_13
from assess.codes.bases.asce43_05 import ASCE43_05
from assess.codes.bases.dmi2008 import DMI2008
from assess.codes.bases.ec8 import EC8
from assess.codes.bases.ntc2018 import NTC2018
from assess.codes.bases.nzsee2017 import NZSEE2017
from assess.codes.basis import Basis

BASES: Mapping[str, Basis] = {each.name: each for each in (NTC2018, DMI2008, NZSEE2017, ASCE41_13, ASCE43_05, EC8)}
BY_SITE: Mapping[str, str] = {"ntc2018": "ntc2018", "ntc2008": "dmi2008", "nzs1170.5": "nzsee2017", "ec8": "ec8"}
"""The basis of a site by the code of its spectrum; on others it must be named."""
