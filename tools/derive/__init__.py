"""Write what follows from the cards and the chapters: what ``make exercises`` runs."""
