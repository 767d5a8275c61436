//! `mindeg explore`: the process, and the commands of its page.

use crate::run::mindeg;

#[cfg(not(feature = "explore"))]
#[test]
fn a_build_without_the_feature_says_how_to_get_it() {
    mindeg(["explore"]).refuses(&["cargo build --release -p mindeg-cli --features explore"]);
}

#[cfg(feature = "explore")]
#[test]
fn a_domain_that_is_none_is_refused_before_anything_listens() {
    let run = mindeg(["explore", "no-such-file.json"]);
    assert_eq!(run.code, Some(1), "{run:?}");
    assert!(run.errors.contains("cannot read no-such-file.json"), "{run:?}");
    mindeg(["explore", "--port", "0"]).refuses(&["--port", "from 1 to 65535"]);
    mindeg(["explore", "--port", "x"]).refuses(&["--port", "from 1 to 65535"]);
    crate::run::mindeg_reading(["explore", "-"], b"{}").refuses(&["standard input"]);
}

#[cfg(all(feature = "explore", unix))]
mod page {
    use crate::run::{Run, Running, hearing_signals, mindeg, shell};
    use serde_json::{Value, json};
    use std::fs;
    use std::io::{BufRead, BufReader, Read, Write};
    use std::net::TcpStream;
    use std::os::unix::process::ExitStatusExt;
    use std::path::{Path, PathBuf};
    use std::process::Stdio;
    use std::thread;
    use std::time::Duration;

    /// A running `mindeg explore` and its address.
    struct Page {
        process: Running,
        host: String,
        token: String,
    }

    impl Page {
        fn open(folder: &Path, arguments: &[&str]) -> Self {
            let mut command = hearing_signals(env!("CARGO_BIN_EXE_mindeg"));
            command.args(["explore", "--no-open"]).args(arguments).current_dir(folder);
            command.stdout(Stdio::piped()).stderr(Stdio::piped()).stdin(Stdio::null());
            let mut process = Running::start(&mut command);
            let mut address = String::new();
            let mut out = BufReader::new(process.take_output());
            out.read_line(&mut address).expect("an address");
            let (host, token) = address
                .trim()
                .strip_prefix("http://")
                .and_then(|rest| rest.split_once("/#"))
                .expect("an address with a token");
            Self { process, host: host.to_owned(), token: token.to_owned() }
        }

        /// The response after the head.
        fn ask(&self, line: &str, body: &Value) -> Vec<u8> {
            let mut stream = TcpStream::connect(&self.host).expect("it listens");
            stream.set_read_timeout(Some(Duration::from_secs(120))).expect("a time limit");
            let body = body.to_string();
            let Self { host, token, .. } = self;
            let request = format!(
                "{line} HTTP/1.1\r\nHost: {host}\r\nX-Mindeg-Token: {token}\r\nConnection: close\r\n\
                 Content-Length: {}\r\n\r\n{body}",
                body.len()
            );
            stream.write_all(request.as_bytes()).expect("a request");
            let mut answer = Vec::new();
            stream.read_to_end(&mut answer).expect("an answer");
            let end = answer.windows(4).position(|four| four == b"\r\n\r\n").expect("a head");
            assert!(answer.starts_with(b"HTTP/1.1 200"), "{}", String::from_utf8_lossy(&answer));
            answer.split_off(end + 4)
        }

        /// The command of the page for a request.
        fn command(&self, request: &Value) -> String {
            self.line(request, "command")["text"].as_str().expect("text").to_owned()
        }

        /// The last line of a kind in the answer to a request.
        fn line(&self, request: &Value, kind: &str) -> Value {
            let answer = self.ask("POST /api/answer?tab=a", request);
            let answer = String::from_utf8(answer).expect("text");
            // Each line is in a chunk of its own, between lines with the lengths of chunks.
            let lines = answer.lines().filter(|line| line.starts_with('{'));
            let mut lines = lines.map(|line| serde_json::from_str::<Value>(line).expect("JSON"));
            lines.rfind(|line| line["kind"] == kind).expect(kind)
        }
    }

    /// A file of several polygons began with the first, and the terminal did not tell of the others.
    #[test]
    fn other_polygons_of_a_file_are_told() {
        let folder = tempfile::tempdir().expect("a folder");
        let (far, one) =
            ("POLYGON((0 0, 4 0, 4 4)) POLYGON((9 0, 12 0, 12 4))", "POLYGON((0 0, 4 0, 4 4))");
        for (content, told) in [
            (
                far,
                "The page begins with polygon 1 and offers 2 more of the file by name; --feature chooses one here.\n",
            ),
            (one, ""),
        ] {
            fs::write(folder.path().join("a.wkt"), content).expect("a file");
            let page = Page::open(folder.path(), &["a.wkt"]);
            // It answers once all is told.
            page.ask("GET /api/start", &Value::Null);
            page.process.send(2);
            let errors = page.process.output().stderr;
            assert_eq!(String::from_utf8_lossy(&errors), format!("{told}Ctrl-C ends it.\n"));
        }
    }

    /// Runs a command of the page as a user would paste it.
    fn pasted(folder: &Path, command: &str) -> Run {
        let programs = Path::new(env!("CARGO_BIN_EXE_mindeg")).parent().expect("a folder");
        shell(folder, &format!("PATH='{}':$PATH\n{command}\n", programs.display()))
    }

    fn preset(name: &str) -> Value {
        let path = format!("{}/assets/domains/{name}.json", env!("CARGO_MANIFEST_DIR"));
        serde_json::from_str(&fs::read_to_string(path).expect("a preset")).expect("JSON")
    }

    /// A surface and a whole model begin in 3D, as they do when they are dropped.
    #[test]
    fn a_surface_or_a_whole_model_is_what_the_page_starts_with() {
        let folder = tempfile::tempdir().expect("a folder");
        for name in ["bracket.obj", "bracket.json"] {
            let file = format!("{}/assets/models/{name}", env!("CARGO_MANIFEST_DIR"));
            let page = Page::open(folder.path(), &[&file]);
            let start: Value =
                serde_json::from_slice(&page.ask("GET /api/start", &json!({}))).expect("JSON");
            assert_eq!((&start["is_solid"], &start["name"]), (&json!(true), &json!(name)));
            let bytes = page.ask("GET /api/start/file", &json!({}));
            assert_eq!(bytes, fs::read(&file).expect("a file"));
        }
        let run = mindeg(["explore", "--help"]);
        let words = run.text();
        assert!(words.contains("a surface in space") && words.contains("whole model"), "{words}");
    }

    /// A file that is repaired when it is dropped is repaired when the page starts with it, with options or without.
    #[test]
    fn what_touches_or_overlaps_is_repaired_with_a_note() {
        let folder = tempfile::tempdir().expect("a folder");
        let overlap = "POLYGON((0 0, 5.02 0, 5.02 5, 0 5)) POLYGON((5 0, 10 0, 10 5, 5 5))";
        fs::write(folder.path().join("overlap.wkt"), overlap).expect("a file");
        let bow = "POLYGON((0 0, 2 2, 4 0, 4 3, 0 3))POLYGON((9 9, 8 9, 9 8))";
        fs::write(folder.path().join("touch.wkt"), bow.replace("2 2", "2 3")).expect("a file");
        let words: [&[&str]; 3] =
            [&["overlap.wkt"], &["overlap.wkt", "--size", "1"], &["touch.wkt", "--size", "1"]];
        for words in words {
            let page = Page::open(folder.path(), words);
            let start: Value =
                serde_json::from_slice(&page.ask("GET /api/start", &json!({}))).expect("JSON");
            assert!(start["domain"].is_object(), "{words:?}: {start}");
            let note = start["notes"][0].as_str().expect("a note");
            assert!(note.contains("they were repaired"), "{words:?}: {note}");
        }
    }

    /// The files of the example domains.
    fn examples() -> Vec<PathBuf> {
        let domains = format!("{}/assets/domains", env!("CARGO_MANIFEST_DIR"));
        let files = fs::read_dir(domains).expect("a folder");
        let mut files: Vec<PathBuf> = files.map(|entry| entry.expect("a file").path()).collect();
        files.sort();
        files
    }

    /// The advice of the page on the domain in a file.
    fn advice_on_page(page: &Page, path: &Path) -> Value {
        let text = fs::read_to_string(path).expect("a domain");
        let domain: Value = serde_json::from_str(&text).expect("JSON");
        page.line(&json!({"domain": domain, "show": ["advice"]}), "advice")
    }

    /// Terminal, table, report and page give the same advice on the domain in a file, and the meshes have its figures. `told`
    /// is the purpose that the table is told.
    fn expect_the_same_advice(page: &Page, path: &Path, told: &str) {
        let folder = tempfile::tempdir().expect("a folder");
        let in_folder = |name: &str| folder.path().join(name).display().to_string();
        let (out, figures) = (in_folder("mesh.obj"), in_folder("figures.json"));
        let file = path.to_str().expect("text");
        let shown = advice_on_page(page, path);
        let words = |purpose: &str| {
            let all = shown["words"].as_array().expect("a list");
            let found = all.iter().find(|it| it[0] == purpose).expect("a purpose");
            found[1].as_str().expect("text").to_owned()
        };
        let on_edges = shown["on_edges"].as_str().unwrap_or_default();
        let texts = [
            mindeg(["tradeoff", file, "-o", &figures]).text().to_owned(),
            mindeg(["mesh", file, "-o", &out]).errors,
            mindeg(["degree", file]).text().to_owned(),
            mindeg(["compare", file, "--json"]).json()["verdict"].to_string(),
        ];
        let first = shown["first"].as_str().expect("a purpose");
        let second = if first == "solver" { "patch" } else { "solver" };
        let made = mindeg(["mesh", file, "--json", "-o", &out]).json();
        // No mesh is advised that was just written.
        let is_patch =
            ["max_degree", "min_angle"].iter().all(|key| made[key] == shown["patch"][key]);
        let patch = words("patch");
        for sentence in [&words(first)[1..], &words(second)[1..], on_edges] {
            let is_made = is_patch && sentence == &patch[1..];
            for (place, text) in texts.iter().enumerate() {
                if place == 1 && is_made {
                    assert!(!text.contains(sentence), "{file}: {text}");
                    continue;
                }
                assert!(text.contains(sentence), "{file}: {sentence} is missing in {text}");
            }
        }
        let figures = fs::read_to_string(figures).expect("figures");
        let figures: Value = serde_json::from_str(&figures).expect("JSON");
        // No mesh of the table has a larger angle than one that is advised or made unasked, and no higher degree. Of a formula's mesh
        // the terminal says that candidates were tried.
        let number = |mesh: &Value, key: &str| mesh[key].as_f64().expect("a number");
        let is_searched = made["found_by"] != "formula";
        for mesh in
            [&shown["patch"], &shown["fewest"]].into_iter().chain(is_searched.then_some(&made))
        {
            let [degree, angle] = ["max_degree", "min_angle"].map(|key| number(mesh, key));
            for row in figures["points"].as_array().expect("rows") {
                let is_better = number(row, "min_angle") > angle * (1.0 + 1e-9);
                assert!(
                    number(row, "max_degree") > degree || !is_better,
                    "{file}: {row} beats {mesh}"
                );
            }
        }
        for purpose in ["solver", "patch", "fewest"] {
            let of_purpose = &shown[purpose];
            assert!(of_purpose.is_object(), "{file}, {purpose}: {shown}");
            assert_eq!(of_purpose, &figures["advice"][purpose], "{file}, {purpose}");
            let made = mindeg(["mesh", file, "--for", purpose, "--json", "-o", &out]).json();
            for key in ["max_degree", "min_angle"] {
                let [told, is] =
                    [&of_purpose[key], &made[key]].map(|it| it.as_f64().expect("a number"));
                assert!((told - is).abs() < 1e-9, "{file}, {purpose}, {key}: {told} {is}");
            }
        }
        // A changed boundary is named with what its command makes.
        let conditioned = &shown["conditioned"];
        assert_eq!(conditioned, &figures["advice"]["conditioned"], "{file}");
        assert_eq!(
            conditioned.is_object(),
            on_edges.contains(" points more, condition it: "),
            "{file}"
        );
        if conditioned.is_object() {
            let made = mindeg(["mesh", file, "--interior", "--condition", "--json", "-o", &out]);
            let made = made.json();
            assert_eq!(made["conditioned"]["inserted"], shown["points_on_edges"], "{file}");
            let [told, is] =
                [conditioned, &made].map(|it| it["min_angle"].as_f64().expect("an angle"));
            assert!((told - is).abs() < 1e-9, "{file}: {told} {is}");
        }
        let is_channel = file.ends_with("boundary-layer-channel.json");
        assert!(!is_channel || conditioned.is_object(), "{shown}");
        // The fewest edges are the first row, and the command of that row makes the same mesh.
        let row = &figures["points"][0];
        let limit = row["max_degree"].to_string();
        let best = ["--max-degree", &limit, "--optimize", "angle", "--json", "-o", &out];
        let made = mindeg([&["mesh", file], &best[..]].concat()).json();
        for figure in [&shown["fewest"]["min_angle"], &made["min_angle"]] {
            let [told, is] = [&row["min_angle"], figure].map(|it| it.as_f64().expect("a number"));
            assert!((told - is).abs() < 1e-9, "{file}: {told} {is}");
        }
        // The table has the mesh with points inside, too.
        let row = texts[0].lines().find(|line| line.ends_with("with points inside"));
        let row = row.expect("a row for points inside");
        let degree = shown["solver"]["max_degree"].to_string();
        assert_eq!(row.split_whitespace().next(), Some(&*degree), "{file}: {row}");
        let table = mindeg(["tradeoff", file, "--for", told]);
        let more = if told == "solver" { on_edges } else { "" };
        let told = [&words(told), more].join(" ");
        assert!(table.text().ends_with(&format!("{}\n", told.trim_end())), "{file}, {told}");
    }

    /// The domain whose advice takes a second of work in each of the places.
    const SLOW: &str = "dominated-side";

    #[test]
    fn the_advice_is_the_same_everywhere() {
        let is_quick = |path: &PathBuf| path.file_stem().is_some_and(|stem| stem != SLOW);
        let mut files: Vec<PathBuf> = examples().into_iter().filter(is_quick).collect();
        assert!(files.len() >= 12, "{files:?}");
        // A coast: too large for the search of all meshes.
        let folder = tempfile::tempdir().expect("a folder");
        let coast = folder.path().join("saronic.json");
        let outline = concat!(env!("CARGO_MANIFEST_DIR"), "/assets/outlines/saronic.geojson");
        let run = mindeg(["domain".as_ref(), outline.as_ref(), "-o".as_ref(), coast.as_os_str()]);
        assert_eq!(run.code, Some(0), "{run:?}");
        files.push(coast);
        let half = |first: usize| {
            let folder = tempfile::tempdir().expect("a folder");
            let page = Page::open(folder.path(), &[]);
            for (place, path) in files.iter().enumerate().skip(first).step_by(2) {
                expect_the_same_advice(&page, path, ["solver", "patch", "fewest"][place % 3]);
            }
        };
        thread::scope(|scope| {
            scope.spawn(|| half(0));
            half(1);
        });
    }

    #[test]
    fn the_advice_on_a_thousand_points_has_the_same_figures_everywhere() {
        let folder = tempfile::tempdir().expect("a folder");
        let page = Page::open(folder.path(), &[]);
        thread::scope(|scope| {
            scope.spawn(|| {
                let path = format!("{}/assets/domains/{SLOW}.json", env!("CARGO_MANIFEST_DIR"));
                let report = mindeg(["compare", &path, "--json"]).json();
                let page = Page::open(folder.path(), &[]);
                let shown = advice_on_page(&page, Path::new(&path));
                for key in ["first", "solver", "conditioned", "patch", "fewest"] {
                    assert_eq!(report["advice"][key], shown[key], "{key}");
                }
            });
            let long = folder.path().join("long.json");
            let text = r#"{"name": "long", "rectangle": {"width": 10, "height": 1}, "size": 0.02}"#;
            fs::write(&long, text).expect("a file");
            expect_the_same_advice(&page, &long, "solver");
        });
    }

    #[test]
    fn pasted_commands_make_the_bytes_of_the_download() {
        let folder = tempfile::tempdir().expect("a folder");
        let page = Page::open(folder.path(), &[]);
        let quoted = json!({
            "name": "it's $HOME `x` \\ \"q\"",
            "polygon": {"corners": [[0, 0], [4, 0], [0.1, 3.3]]},
            "size": 0.25,
            "interior": {"target_angle": 10.0}
        });
        let channel = preset("boundary-layer-channel");
        for (domain, goal, view, format, file) in [
            (
                &channel,
                json!({"keep_angle": 0.95}),
                "wanted",
                "glb",
                "boundary-layer-channel-keep-angle-95.glb",
            ),
            (
                &channel,
                json!({"keep_angle": 1.0 / 3.0}),
                "wanted",
                "obj",
                "boundary-layer-channel-keep-angle-0-3333333333333333.obj",
            ),
            (
                &channel,
                json!({"max_degree": 6}),
                "wanted",
                "msh",
                "boundary-layer-channel-max-degree-6.msh",
            ),
            (
                &channel,
                json!("least_degree"),
                "least",
                "fort14",
                "boundary-layer-channel-least-degree.14",
            ),
            (
                &preset("great-britain"),
                json!("least_degree"),
                "wanted",
                "svg",
                "great-britain-least-degree.svg",
            ),
            (
                &preset("plate-with-holes"),
                json!("least_degree"),
                "interior",
                "vtu",
                "plate-with-holes-points-inside.vtu",
            ),
            (
                &quoted,
                json!({"keep_angle": 0.9}),
                "wanted",
                "2dm",
                "it-s-home-x-q-keep-angle-90.2dm",
            ),
            (&quoted, json!("least_degree"), "interior", "npz", "it-s-home-x-q-points-inside.npz"),
        ] {
            let request = json!({
                "domain": domain, "goal": goal, "view": view, "format": format, "show": ["command"]
            });
            let command = page.command(&request);
            let run = pasted(folder.path(), &command);
            assert_eq!(run.code, Some(0), "{command}\n{}", run.errors);
            let download = page.ask(&format!("POST /api/download?format={format}"), &request);
            let made = fs::read(folder.path().join(file)).expect(&command);
            assert!(made == download, "{command}: {} and {} bytes", made.len(), download.len());
        }
    }

    #[test]
    fn the_command_for_delaunay_s_mesh_saves_it() {
        let folder = tempfile::tempdir().expect("a folder");
        let page = Page::open(folder.path(), &[]);
        let request =
            json!({"domain": preset("l-bracket"), "view": "delaunay", "show": ["command"]});
        let command = page.command(&request);
        let run = pasted(folder.path(), &command);
        assert_eq!(run.code, Some(0), "{command}\n{}", run.errors);
        let made = fs::read(folder.path().join("l-bracket-compared/delaunay.obj")).expect("a mesh");
        let download = page.ask("POST /api/download?format=obj", &request);
        assert!(made == download, "{command}");
    }

    #[test]
    fn a_command_names_the_file_of_a_domain_that_is_as_it_was() {
        let folder = tempfile::tempdir().expect("a folder");
        let text = preset("wing-panel").to_string();
        fs::write(folder.path().join("my wing.json"), &text).expect("a file");
        fs::create_dir_all(folder.path().join("assets/domains")).expect("a folder");
        let known = folder.path().join("assets/domains/l-bracket.json");
        fs::write(known, preset("l-bracket").to_string()).expect("a file");
        let page = Page::open(folder.path(), &["my wing.json"]);
        let mut domain = preset("wing-panel");
        let request = |domain: &Value| json!({"domain": domain, "show": ["command"]});
        assert_eq!(
            page.command(&request(&domain)),
            "mindeg mesh 'my wing.json' -o wing-panel-least-degree.obj"
        );
        assert_eq!(
            page.command(&request(&preset("l-bracket"))),
            "mindeg mesh assets/domains/l-bracket.json -o l-bracket-least-degree.obj"
        );
        domain["name"] = json!("other");
        assert!(
            page.command(&request(&domain))
                .starts_with("mindeg mesh - -o other-least-degree.obj <<'END'\n{")
        );
    }

    #[test]
    fn options_say_how_the_file_is_read_and_the_command_has_them() {
        let folder = tempfile::tempdir().expect("a folder");
        let assets = format!("{}/assets/outlines", env!("CARGO_MANIFEST_DIR"));
        for file in ["saronic.geojson", "part.dxf"] {
            fs::copy(format!("{assets}/{file}"), folder.path().join(file)).expect("a copy");
        }
        for (words, made) in [
            ("saronic.geojson --size 2km --project auto", "saronic-points-inside.14"),
            ("--rectangle 4x3 --size 0.5", "mesh-points-inside.14"),
            ("part.dxf", "part-points-inside.14"),
        ] {
            let page = Page::open(folder.path(), &words.split(' ').collect::<Vec<_>>());
            let start = String::from_utf8(page.ask("GET /api/start", &Value::Null)).expect("text");
            let start = &start[start.find('{').expect("JSON")..=start.rfind('}').expect("JSON")];
            let start: Value = serde_json::from_str(start).expect("JSON");
            let domain = &start["domain"];
            let request = json!({"domain": domain, "view": "interior", "format": "fort14", "show": ["command"]});
            let command = page.command(&request);
            assert_eq!(command, format!("mindeg mesh {words} --interior -o {made}"));
            let run = pasted(folder.path(), &command);
            assert_eq!(run.code, Some(0), "{command}\n{}", run.errors);
            let download = page.ask("POST /api/download?format=fort14", &request);
            assert!(fs::read(folder.path().join(made)).expect("a mesh") == download, "{command}");
        }
        let refused = mindeg(["explore", "--rectangle", "4x3", "--size", "1e-5"]);
        refused.refuses(&["domain: the outline has 1400000 points; the page takes up to 100000"]);
    }

    /// The page lists the polygons of the file that it starts with, and each has a name.
    #[test]
    fn a_file_of_several_polygons_has_all_of_them_at_the_start() {
        let folder = tempfile::tempdir().expect("a folder");
        let islands = format!("{}/assets/outlines/islands.geojson", env!("CARGO_MANIFEST_DIR"));
        for words in [&[&*islands][..], &[&*islands, "--size", "0.5"]] {
            let page = Page::open(folder.path(), words);
            let ask = |path: &str| -> Value {
                serde_json::from_slice(&page.ask(path, &Value::Null)).expect("JSON")
            };
            let choices = ask("GET /api/start/choices");
            let choices = choices.as_array().expect("a list");
            assert!(choices.len() >= 3, "{words:?}: {choices:?}");
            assert_eq!(choices[1]["domain"], ask("GET /api/start")["domain"]);
            // All of them together come first: the mesh is that of the command beside it.
            let whole = &choices[0]["map"];
            let shown: Value =
                serde_json::from_slice(&page.ask("POST /api/whole?purpose=fewest", whole))
                    .expect("JSON");
            let saved = page.ask("POST /api/whole/file?purpose=fewest&format=obj", whole);
            let command = shown["command"].as_str().expect("a command");
            let out = folder.path().join(command.rsplit(' ').next().expect("a file"));
            let run = pasted(folder.path(), command);
            assert_eq!(run.code, Some(0), "{command}: {}", run.errors);
            let lines = |bytes: &[u8], start: &str| {
                let text = String::from_utf8_lossy(bytes).into_owned();
                text.lines()
                    .filter(|line| line.starts_with(start))
                    .map(str::to_owned)
                    .collect::<Vec<_>>()
            };
            let made = fs::read(out).expect("a mesh");
            for start in ["v ", "f "] {
                assert!(lines(&saved, start) == lines(&made, start), "{command}: {start}");
            }
            assert_eq!(shown["triangles"], lines(&made, "f ").len());
            for choice in &choices[1..] {
                let name = choice["domain"]["name"].as_str().unwrap_or_default();
                assert!(!name.is_empty() && choice["name"] != "domain", "{choice}");
            }
        }
        let page = Page::open(folder.path(), &["--rectangle", "4x3", "--size", "1"]);
        assert_eq!(page.ask("GET /api/start/choices", &Value::Null), b"[]");
    }

    #[test]
    fn ctrl_c_ends_it() {
        let folder = tempfile::tempdir().expect("a folder");
        for signal in [2, 15] {
            let mut page = Page::open(folder.path(), &[]);
            page.process.send(signal);
            assert_eq!(page.process.status().signal(), Some(signal));
            assert!(TcpStream::connect(&page.host).is_err());
        }
    }

    #[test]
    fn a_port_that_is_taken_is_refused() {
        let folder = tempfile::tempdir().expect("a folder");
        let page = Page::open(folder.path(), &[]);
        let port = page.host.rsplit_once(':').expect("a port").1;
        let run = mindeg(["explore", "--no-open", "--port", port]);
        assert_eq!(run.code, Some(1), "{run:?}");
        assert!(run.errors.contains(&format!("cannot listen on port {port}")), "{run:?}");
    }
}
