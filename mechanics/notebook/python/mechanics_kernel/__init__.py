"""A Jupyter kernel for mechanics: passes messages to the Racket process that evaluates cells."""
