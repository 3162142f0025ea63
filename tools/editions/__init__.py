"""Make the editions: the pages for instructors, the zip for learners."""
