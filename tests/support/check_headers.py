"""Checks that each header compiles alone, and twice in a row.

    check_headers.py HEADER... -- FLAG...

The compiler is $CXX. Prints the messages of those that fail and exits with 1 if there is any.
"""

import concurrent.futures
import os
import subprocess
import sys


def compile_alone(header, flags):
    """The compiler's messages; empty where the header compiles."""
    command = [os.environ.get("CXX", "g++"), *flags, "-fsyntax-only", "-x", "c++", "-"]
    source = f'#include "{os.path.abspath(header)}"\n' * 2
    run = subprocess.run(command, input=source, capture_output=True, text=True, check=False)
    return "" if run.returncode == 0 else run.stderr or f"{header}: the compiler failed\n"


def check(headers, flags):
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        return [text for text in pool.map(lambda header: compile_alone(header, flags), headers)
                if text]


if __name__ == "__main__":
    split = sys.argv.index("--")
    headers = sys.argv[1:split]
    failed = check(headers, sys.argv[split + 1:])
    print("".join(failed), end="")
    print(f"headers: {len(headers) - len(failed)} of {len(headers)} compile alone")
    sys.exit(1 if failed or not headers else 0)
