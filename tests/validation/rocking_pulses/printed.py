"""Amplitudes A at which a pulse of frequency Omega begins to overturn a block without impact, as they were printed."""

ONE_SINE = {
    0.5: 1.118049951788, 1.0: 1.418315335579, 2.0: 2.349903126956, 3.0: 3.631149872445,
    4.0: 5.238964357602, 5.0: 7.168128797071, 6.0: 9.416965707688, 8.0: 14.871352061270,
}  # fmt: skip
HALF_SINE = {
    0.5: 1.109417823, 1.0: 1.322396598, 2.0: 1.800723931, 3.0: 2.293872313, 4.0: 2.790798012, 6.0: 3.788155166,
}  # fmt: skip
