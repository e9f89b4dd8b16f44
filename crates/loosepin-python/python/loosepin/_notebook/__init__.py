"""How objects and progress look in a notebook."""
