"""Make an environment and print its Python, or lock all of them with ``--lock``."""

import sys

from tools.environments import (
    NoEnvironmentError,
    list_environments,
    lock_environments,
    make_environment,
)


def main(arguments: list[str]) -> int:
    """Do what the command line asks for; return a shell's exit code."""
    if len(arguments) != 1:
        names = ", ".join(list_environments())
        print(f"environments: expected --lock or one of {names}", file=sys.stderr)
        return 2
    try:
        if arguments == ["--lock"]:
            lock_environments()
        else:
            print(make_environment(arguments[0]))
    except (NoEnvironmentError, ValueError) as error:
        print(f"environments: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
