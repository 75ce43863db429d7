"""python -m domeshim: the same as the domeshim command."""

from domeshim.cli import main

if __name__ == "__main__":
    main()
