"""Italian procedure of DM 14.01.2008 with Circolare 617/2009."""
