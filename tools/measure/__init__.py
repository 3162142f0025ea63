"""Measure over many views and seeds what a page can only show once; write the tables it shows."""
