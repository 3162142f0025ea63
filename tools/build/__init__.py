"""Set up the environment and build the pages."""
