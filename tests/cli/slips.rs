//! What the likely slips are answered with: the whole message.

use crate::run::{mindeg, mindeg_reading};

/// Arguments separated by spaces, `"` for one that has spaces; and the message up to the first
/// empty line.
const SLIPS: &[(&str, &str)] = &[
    (
        "mesh --corners 0,0 4,0 3,2 --size 1 -o x.obj",
        "--corners takes all corners as one value; put them in quotes: --corners \"0,0 4,0 3,2\"",
    ),
    (
        "mesh --corners \"(0,0) (4,0) (3,2)\" --size 1 -o x.obj",
        "invalid value '(0,0) (4,0) (3,2)' for '--corners <x,y x,y …>': corner 1: leave out the \
         brackets, such as \"0,0 4,0 3,2\"",
    ),
    (
        "mesh --corners \"0 0, 4 0, 3 2\" --size 1 -o x.obj",
        "invalid value '0 0, 4 0, 3 2' for '--corners <x,y x,y …>': corner 1: put a comma between \
         x and y, and spaces between corners, such as \"0,0 4,0 3,2\"",
    ),
    (
        "mesh --corners \"0,0,0 4,0,0\" --size 1 -o x.obj",
        "invalid value '0,0,0 4,0,0' for '--corners <x,y x,y …>': corner 1: a corner has two \
         coordinates, such as \"0,0 4,0 3,2\"",
    ),
    (
        "mesh --rectangle 4 3 --size 1 -o x.obj",
        "join width and height by an x, without spaces: --rectangle 4x3",
    ),
    (
        "mesh --rectangle 4,3 --size 1 -o x.obj",
        "invalid value '4,3' for '--rectangle <WxH>': give a width and a height with an x between, \
         such as 4x3",
    ),
    (
        "mesh --rectangle 4x3 --size -1 -o x.obj",
        "invalid value '-1' for '--size <S>': give a length above 0, such as 0.5",
    ),
    (
        "mesh --rectangle 4x3 --size abc -o x.obj",
        "invalid value 'abc' for '--size <S>': give a length above 0, such as 0.5",
    ),
    (
        "mesh --rectangle 4x3 --intervals 3 3 2 2 -o x.obj",
        "join the counts by commas, without spaces: --intervals 3,3,2,2",
    ),
    (
        "mesh --rectangle 4x3 --intervals 3,3,2 -o x.obj",
        "--intervals gives 3 counts for 4 sides; give one for each side, counter-clockwise",
    ),
    (
        "mesh --rectangle 4x3 --size 1 --spacing geometric -o x.obj",
        "invalid value 'geometric' for '--spacing <LAW>': geometric takes a ratio, such as \
         geometric:1.2",
    ),
    ("mesh --rectangle 4x3 -o x.obj", "how many intervals? give --intervals a,b,… or --size S"),
    (
        "mesh -o x.obj",
        "no domain: name its file, or - for standard input, or give --rectangle or --corners",
    ),
    ("mesh plate.json", "where to? name a file, such as -o mesh.obj"),
    ("mesh - -o x.obj", "standard input is empty; a domain is expected"),
    (
        "mesh a.stl -o b.obj",
        "a.stl: it is a mesh, and a domain is expected; of a mesh in the plane, `mindeg convert a.stl -o \
         outline.poly` writes the boundary, which is a domain",
    ),
    (
        "mesh a.json b.json -o x.obj",
        "one domain at a time: b.json is a second one; mindeg compare takes several",
    ),
    (
        "mesh a.geojson bow.geojson -o x.obj",
        "one domain at a time: bow.geojson is a second one; mindeg compare takes several",
    ),
    (
        "coast.geojson",
        "coast.geojson is no command; name one before the file, such as mindeg mesh coast.geojson -o \
         mesh.obj",
    ),
    ("mesh a.json x.obj", "give every output with -o: -o x.obj"),
    (
        "mesh --rectangle 4x3 --size 1 -o q.fbx --format obj",
        "q.fbx: mindeg does not write .fbx files; end the name in .obj for what --format asks \
         for",
    ),
    (
        "mesh --rectangle 4x3 --size 1 -o x.gltf -o x.bin --format obj",
        "two outputs would write x.bin (a .gltf has a .bin beside it)",
    ),
    (
        "mesh --rectangle 4x3 --size 1 -o y.gltf -o y.GLTF",
        "two outputs would write y.bin (a .gltf has a .bin beside it)",
    ),
    (
        "mesh --rectangle 4x3 --size 1 --max-degree 4.5 -o x.obj",
        "invalid value '4.5' for '--max-degree <D>': give a whole number of 0 or more, such as 5",
    ),
    (
        "mesh --rectangle 4x3 --size 1 --max-degree 3 -o x.obj",
        "no mesh of the domain has maximum degree 3; the least is 4",
    ),
    ("mesh --rectangle 4x3 --size 1 --min-angle 3 -o x.obj", "--min-angle is now --target-angle"),
    (
        "mesh --rectangle 4x3 --size 1 --fail-below-angle 3 -o x.obj",
        "--fail-below-angle is now --target-angle",
    ),
    ("inspect a.obj --fail-above-degree 6", "--fail-above-degree is now --max-degree"),
    ("verify a.obj a.json --min-angle 6", "--min-angle is now --target-angle"),
    ("suggest 30,2,4,2 --target 5", "--target is now --max-degree"),
    (
        "mesh --rectangle 4x3 --size 1 --target-angle 61 -o x.obj",
        "invalid value '61' for '--target-angle <A>': give degrees from 0 to 60; no triangle \
         has only larger angles",
    ),
    ("degree 3 3 2 2", "join the counts by commas, without spaces: mindeg degree 3,3,2,2"),
    ("degree 3, 3, 2, 2", "join the counts by commas, without spaces: mindeg degree 3,3,2,2"),
    (
        "degree 18446744073709551616,1,1",
        "invalid value '18446744073709551616,1,1' for '[INTERVALS|DOMAIN]': side 1: the \
         maximum is 4294967294 intervals",
    ),
    (
        "degree wing",
        "invalid value 'wing' for '[INTERVALS|DOMAIN]': side 1: give a whole number of \
         intervals for each side, such as 3,3,2,2",
    ),
    (
        "suggest 30,2,4,2 --max-degree -1",
        "invalid value '-1' for '--max-degree <D>': give a whole number of 0 or more, such as 5",
    ),
    (
        "compare --rectangle 4x3 --size 1 -o x.html --time-limit abc",
        "invalid value 'abc' for '--time-limit <SECONDS>': give a number of seconds from 0 on, \
         such as 60",
    ),
    ("compare --rectangle 4x3 --size 1 -o -", "-o -: give --format html, json or md"),
    (
        "compare --rectangle 4x3 --size 1 -o reports",
        "-o reports: a report ends in .html, .json or .md; a folder ends in /",
    ),
    ("convert a.obj b.glb", "give every output with -o: -o b.glb"),
    ("fill a.obj", "where to? name a file, such as -o mesh.obj"),
    ("bridge a.obj b.obj", "where to? name a file, such as -o mesh.obj"),
    ("inspect a.obj b.obj", "one mesh at a time: b.obj is a second one"),
    (
        "plate.json",
        "plate.json is no command; name one before the file, such as mindeg mesh plate.json -o \
         mesh.obj",
    ),
];

/// The arguments of a line, as a shell sees them.
fn words(line: &str) -> Vec<&str> {
    let mut words = Vec::new();
    for (i, quoted) in line.split('"').enumerate() {
        if i % 2 == 0 { words.extend(quoted.split_whitespace()) } else { words.push(quoted) }
    }
    words
}

#[test]
fn likely_slips_are_answered_with_what_was_meant() {
    for &(line, message) in SLIPS {
        let run = mindeg(words(line));
        assert_eq!(run.code, Some(2), "{line}: {run:?}");
        let (first, _) = run.errors.split_once("\n\n").unwrap_or((run.errors.trim_end(), ""));
        assert_eq!(first, format!("error: {message}"), "{line}");
    }
}

#[test]
fn no_message_has_words_of_the_libraries() {
    let foreign = [
        "invalid digit",
        "too large to fit",
        "from empty string",
        "invalid float",
        "os error",
        "EOF while",
        ".part",
        "expected struct",
    ];
    let lines = [
        "suggest 3,3,3 --limit x",
        "inspect a.obj --poles-above x",
        "mesh no/such.json -o x.obj",
        "mesh --rectangle 4x3 --size 1 -o no/such/x.obj",
        "degree ,",
        "inspect no.obj",
        "mesh --rectangle 4x3 --size 1 -o /proc/x.obj",
        "mesh --rectangle 4x3 --size= -o x.obj",
    ];
    for line in lines.into_iter().chain(SLIPS.iter().map(|&(line, _)| line)) {
        let run = mindeg(words(line));
        assert!(matches!(run.code, Some(1 | 2)), "{line}: {run:?}");
        for word in foreign {
            assert!(!run.errors.contains(word), "{line}: {}", run.errors);
        }
    }
    for empty in ["", " \n"] {
        mindeg_reading(["tradeoff", "-"], empty.as_bytes()).refuses(&["standard input is empty"]);
    }
}
