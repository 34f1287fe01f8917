"""What scripts/report is made of: readers of runs, what is told by them, and the page."""
