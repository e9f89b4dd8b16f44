#!/usr/bin/env bash
# Writes gnu_as_encodings.txt: what GNU as makes of the instructions that the test `peer_gnu_as_encodes_the_same_bytes`
# lists when it fails.
#
#     cargo test --package loosepin-tape --lib peer_gnu_as 2>&1 | crates/loosepin-tape/src/native/gnu_as_encodings.sh
#
# Only the texts are read, not the bytes beside them. Needs GNU binutils (made with 2.40) and awk.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT

grep -P '^[0-9a-f]+\t' | cut -f2 > "$work/texts"
{
    echo ".intel_syntax noprefix"
    # Each instruction between two marks that no instruction contains, so that its bytes can be cut out.
    while IFS= read -r text; do
        printf '%s\n.ascii "NEXT\\n"\n' "$text"
    done < "$work/texts"
} > "$work/instructions.s"
as --64 -o "$work/instructions.o" "$work/instructions.s"
objcopy --output-target=binary --only-section=.text "$work/instructions.o" "$work/instructions.bin"
xxd -p -c 0 "$work/instructions.bin" | sed 's/4e4558540a/\n/g' | sed '/^$/d' > "$work/bytes"
paste "$work/bytes" "$work/texts" > "$here/gnu_as_encodings.txt"
