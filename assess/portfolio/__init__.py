"""Many projects assessed as one: tasks, the processes that compute them, and the ledger of what is done."""
