"""Speed beside other programs, with the error of each beside its time: `make peers`."""
