"""Write the files of a new chapter or exercise, and name what is still to be filled in them."""
