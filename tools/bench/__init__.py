"""Measure speed, as ratios against named peers: what ``make bench`` runs."""
