"""What the Italian procedures share: DM 2008 with Circolare 617/2009 and NTC 2018 with Circolare 7/2019."""
