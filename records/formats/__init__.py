"""Readers of record files, one module for each format, and their registry."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path

from records.formats import afad, by_obspy, cosmos, csmip, csv, dyna, geonet_v2a, itaca, knet, peer_at2, plain, smc
from records.formats.header import HeaderOverrides
from records.record import Record


@dataclass(frozen=True)
class Format:
    """One format: whether the first bytes of a file are of it, and how every record of the whole is read."""

    looks_like: Callable[[bytes], bool]
    read: Callable[[Path, HeaderOverrides], tuple[Record, ...]]


FORMATS: Mapping[str, Format] = {
    peer_at2.NAME: Format(peer_at2.looks_like, peer_at2.read),
    knet.NAME: Format(knet.looks_like, knet.read),
    dyna.NAME: Format(dyna.looks_like, dyna.read),
    itaca.NAME: Format(itaca.looks_like, itaca.read),
    cosmos.NAME: Format(cosmos.looks_like, cosmos.read),
    csmip.NAME: Format(csmip.looks_like, csmip.read),
    geonet_v2a.NAME: Format(geonet_v2a.looks_like, geonet_v2a.read),
    smc.NAME: Format(smc.looks_like, smc.read),
    afad.NAME: Format(afad.looks_like, afad.read),
    by_obspy.MINISEED: Format(by_obspy.looks_like_miniseed, by_obspy.read_miniseed),
    by_obspy.SAC: Format(by_obspy.looks_like_sac, by_obspy.read_sac),
    csv.NAME: Format(csv.looks_like, csv.read),
    plain.NAME: Format(plain.looks_like, plain.read),
}
