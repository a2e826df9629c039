"""Where machine code is kept between runs: one folder for all kernels, here because each of them can reach it."""
