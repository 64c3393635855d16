"""``python -m affinecert``: the command line."""

from affinecert.cli import main

if __name__ == "__main__":
    main(prog_name="affinecert")
