"""Fetch front-end files and Python for the pages, at pinned versions."""
