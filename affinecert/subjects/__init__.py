"""Built-in subjects, one a module; each module has one public name, ``subject``."""
