"""Italian procedure of NTC 2018 with Circolare 7/2019."""
