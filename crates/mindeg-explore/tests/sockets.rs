//! The server through real sockets: who is let in, and what is bounded.

use std::io::{ErrorKind, Read, Write};
use std::net::TcpStream;
use std::thread;
use std::time::{Duration, Instant};

use mindeg_explore::{Server, Setup};
use serde_json::{Value, json};

/// A running server; its thread ends with the tests.
struct Running {
    host: String,
    token: String,
}

/// The response.
struct Answer {
    status: u16,
    head: String,
    body: Vec<u8>,
}

impl Answer {
    #[track_caller]
    fn json(&self) -> Value {
        serde_json::from_slice(&self.body).unwrap()
    }
}

fn server() -> Running {
    let server = Server::new(Setup::default()).unwrap();
    let address = server.address();
    thread::spawn(move || server.run().map(|_| ()));
    let (host, token) = address.strip_prefix("http://").unwrap().split_once("/#").unwrap();
    assert!(token.len() == 64 && token.bytes().all(|byte| byte.is_ascii_hexdigit()));
    Running { host: host.to_owned(), token: token.to_owned() }
}

impl Running {
    fn connect(&self) -> TcpStream {
        let stream = TcpStream::connect(&self.host).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(120))).unwrap();
        stream
    }

    /// Sends a request unchanged and reads to the end.
    fn raw(&self, request: &[u8]) -> Answer {
        let mut stream = self.connect();
        // A server that refuses early may close before all is sent.
        let _ = stream.write_all(request);
        read(&mut stream)
    }

    /// A request with these headers besides those that every browser sends.
    fn request(&self, line: &str, headers: &[(&str, &str)], body: &[u8]) -> Answer {
        self.raw(&self.bytes(line, headers, body))
    }

    fn bytes(&self, line: &str, headers: &[(&str, &str)], body: &[u8]) -> Vec<u8> {
        let mut head = format!("{line} HTTP/1.1\r\nConnection: close\r\n");
        if !headers.iter().any(|(name, _)| *name == "Host") {
            head += &format!("Host: {}\r\n", self.host);
        }
        for (name, value) in headers {
            head += &format!("{name}: {value}\r\n");
        }
        head += &format!("Content-Length: {}\r\n\r\n", body.len());
        [head.as_bytes(), body].concat()
    }

    /// A request with the token.
    fn ask(&self, line: &str, body: &[u8]) -> Answer {
        self.request(line, &[("X-Mindeg-Token", &self.token)], body)
    }
}

/// The rest of the response, unchanged.
fn what_is_left(stream: &mut TcpStream) -> Vec<u8> {
    let mut bytes = Vec::new();
    match stream.read_to_end(&mut bytes) {
        Ok(_) => {}
        Err(error) if error.kind() == ErrorKind::ConnectionReset => {}
        Err(error) => panic!("{error}"),
    }
    bytes
}

fn read(stream: &mut TcpStream) -> Answer {
    let bytes = what_is_left(stream);
    let end = bytes.windows(4).position(|four| four == b"\r\n\r\n").unwrap_or(bytes.len());
    let head = String::from_utf8_lossy(&bytes[..end]).into_owned();
    let status = head.split(' ').nth(1).and_then(|status| status.parse().ok()).unwrap_or(0);
    let body = bytes.get(end + 4..).unwrap_or_default().to_vec();
    let body = if head.to_lowercase().contains("transfer-encoding: chunked") {
        joined(&body)
    } else {
        body
    };
    Answer { status, head, body }
}

/// A chunked body without its chunks.
fn joined(mut body: &[u8]) -> Vec<u8> {
    let mut whole = Vec::new();
    while let Some(end) = body.windows(2).position(|two| two == b"\r\n") {
        let len = usize::from_str_radix(std::str::from_utf8(&body[..end]).unwrap(), 16).unwrap();
        whole.extend_from_slice(&body[end + 2..][..len]);
        body = &body[end + 2 + len + 2..];
    }
    whole
}

fn plate(size: f64) -> Value {
    json!({"name": "plate", "rectangle": {"width": 4, "height": 3}, "size": size})
}

#[test]
fn the_page_needs_no_token_and_loads_nothing_from_elsewhere() {
    let server = server();
    let page = server.request("GET /", &[], b"");
    assert_eq!(page.status, 200);
    let head = page.head.to_lowercase();
    for header in [
        "content-security-policy: default-src 'none'; script-src 'self'; style-src 'self'; \
         img-src 'self' data: blob:; connect-src 'self'; frame-ancestors 'none'; base-uri 'none'; \
         form-action 'none'",
        "x-content-type-options: nosniff",
        "cache-control: no-store",
        "referrer-policy: no-referrer",
        "cross-origin-resource-policy: same-origin",
        "cross-origin-opener-policy: same-origin",
        "content-type: text/html; charset=utf-8",
    ] {
        assert!(head.contains(header), "{header} is missing in {head}");
    }
    assert!(!head.contains("access-control"));
    assert_eq!(server.request("GET /page/explore.js", &[], b"").status, 200);
    for missing in ["/page/secret", "/page/../Cargo.toml", "/page/%2e%2e%2fCargo.toml", "/x"] {
        assert_eq!(server.request(&format!("GET {missing}"), &[], b"").status, 404, "{missing}");
    }
    // The token is the fragment of the address alone.
    assert!(!String::from_utf8_lossy(&page.body).contains(&server.token));
}

#[test]
fn strangers_are_refused() {
    let server = server();
    let port = server.host.rsplit_once(':').unwrap().1;
    let token = ("X-Mindeg-Token", server.token.as_str());
    let half = ("X-Mindeg-Token", &server.token[..32]);
    let other = "0".repeat(64);
    let other = ("X-Mindeg-Token", other.as_str());
    let ours = format!("http://{}", server.host);
    let same_host = format!("localhost:{port}");
    for headers in [
        &[][..],
        &[half],
        &[other],
        &[token, token],
        &[token, ("Host", "evil.example")],
        &[token, ("Host", &format!("evil.example:{port}"))],
        &[token, ("Host", &format!("127.evil.example:{port}"))],
        &[token, ("Host", &format!("127.0.0.1.evil.example:{port}"))],
        &[token, ("Host", "127.0.0.1")],
        &[token, ("Host", "127.0.0.1:1")],
        &[token, ("Host", &format!("127.0.0.1:0{port}"))],
        &[token, ("Host", &format!("user@127.0.0.1:{port}"))],
        &[token, ("Host", &same_host), ("Host", &server.host)],
        &[token, ("Host", "")],
        // It listens on IPv4 alone.
        &[token, ("Host", &format!("[::1]:{port}"))],
        &[token, ("Origin", "http://evil.example")],
        &[token, ("Origin", "null")],
        &[token, ("Origin", &format!("https://{}", server.host))],
        &[token, ("Origin", &format!("http://localhost:{port}"))],
        &[token, ("Origin", "http://127.0.0.1:1")],
        &[token, ("Origin", &ours), ("Origin", "http://evil.example")],
        &[token, ("Sec-Fetch-Site", "cross-site")],
        &[token, ("Sec-Fetch-Site", "same-site")],
        &[token, ("Sec-Fetch-Site", "cross-site"), ("Sec-Fetch-Mode", "navigate")],
        &[token, ("Sec-Fetch-Site", "none"), ("Sec-Fetch-Site", "none")],
    ] {
        for line in
            ["GET /api/presets", "POST /api/answer?tab=a", "PUT /api/state/a", "GET /api/no"]
        {
            let answer = server.request(line, headers, b"{}");
            assert_eq!(answer.status, 403, "{line} {headers:?}: {}", answer.head);
            let message = answer.json()["message"].as_str().unwrap().to_owned();
            assert!(!message.contains(&server.token));
        }
    }
    for headers in [
        &[token][..],
        &[token, ("Host", &same_host)],
        &[token, ("Origin", &ours), ("Sec-Fetch-Site", "same-origin")],
        &[token, ("Host", &same_host), ("Origin", &format!("http://{same_host}"))],
        &[token, ("Sec-Fetch-Site", "none")],
    ] {
        let answer = server.request("GET /api/presets", headers, b"");
        assert_eq!(answer.status, 200, "{headers:?}: {}", answer.head);
    }
    // A link on another page may lead to the page; it may not embed or load it.
    let followed = [("Sec-Fetch-Site", "cross-site"), ("Sec-Fetch-Mode", "navigate")];
    assert_eq!(server.request("GET /", &followed, b"").status, 200);
    let loaded = [("Sec-Fetch-Site", "cross-site"), ("Sec-Fetch-Mode", "no-cors")];
    assert_eq!(server.request("GET /page/explore.js", &loaded, b"").status, 403);
    assert_eq!(server.request("GET /", &[("Host", "evil.example")], b"").status, 403);
    assert_eq!(server.request("POST /", &[], b"").status, 405);
}

#[test]
fn another_address_of_the_machine_does_not_listen() {
    let server = server();
    let port: u16 = server.host.rsplit_once(':').unwrap().1.parse().unwrap();
    assert!(server.host.starts_with("127.0.0.1:"));
    assert!(TcpStream::connect(("127.0.0.2", port)).is_err());
}

#[test]
fn bodies_and_heads_are_bounded() {
    let server = server();
    let token = ("X-Mindeg-Token", server.token.as_str());
    let huge = vec![b' '; (8 << 20) + 1];
    for line in ["POST /api/answer?tab=a", "POST /api/read?name=a", "PUT /api/state/a"] {
        assert_eq!(server.request(line, &[token], &huge).status, 413, "{line}");
    }
    // It promises more than it sends: it is refused for what it promises, at once.
    let start = Instant::now();
    let head = format!(
        "POST /api/answer?tab=a HTTP/1.1\r\nHost: {}\r\nX-Mindeg-Token: {}\r\nConnection: close\r\n\
         Content-Length: 999999999999\r\n\r\n",
        server.host, server.token
    );
    assert_eq!(server.raw(head.as_bytes()).status, 413);
    assert!(start.elapsed() < Duration::from_secs(20));
    // Chunks without an end.
    let head = head.replace("Content-Length: 999999999999", "Transfer-Encoding: chunked");
    let chunk = [b"100000\r\n".as_slice(), &vec![b' '; 1 << 20], b"\r\n"].concat();
    let endless = [head.as_bytes(), &chunk.repeat(9)].concat();
    assert_eq!(server.raw(&endless).status, 413);
    let long = [("X-Long", "x".repeat(1 << 20))];
    let long = server.request("GET /", &[(long[0].0, &long[0].1)], b"");
    assert!(matches!(long.status, 0 | 400 | 431), "{}", long.status);
    for broken in
        [&b"\0\0\0\0\r\n\r\n"[..], b"GET / HTTP/9.9\r\n\r\n", b"\x16\x03\x01\x02\x00\x01\r\n\r\n"]
    {
        assert!(matches!(server.raw(broken).status, 0 | 400), "{broken:?}");
    }
    // It still answers.
    assert_eq!(server.ask("GET /api/start", b"").json()["name"], "boundary-layer-channel");
}

#[test]
fn queries_and_names_are_checked() {
    let server = server();
    let long = "a".repeat(65);
    for line in [
        "POST /api/answer",
        "POST /api/answer?tab=",
        "POST /api/answer?tab=a%20b",
        &format!("POST /api/answer?tab={long}"),
        "POST /api/read",
        "POST /api/download",
        "POST /api/download?format=obj&file=x",
        "PUT /api/state/a.b",
        &format!("PUT /api/state/{long}"),
    ] {
        let answer = server.ask(line, b"{}");
        assert_eq!(answer.status, 400, "{line}");
        assert!(answer.json()["message"].is_string(), "{line}");
    }
    let get = server.ask("GET /api/answer?tab=a", b"");
    assert_eq!((get.status, get.json()["message"].is_string()), (405, true));
    assert_eq!(server.ask("PUT /api/state/a", b"{").status, 400);
    for line in ["POST /api/download?format=exe", "POST /api/download?format=gltf&file=9"] {
        let body = json!({"domain": plate(1.0)}).to_string();
        let answer = server.ask(line, body.as_bytes());
        assert_eq!(answer.status, 422, "{line}");
        assert!(answer.json()["message"].is_string());
    }
}

#[test]
fn lines_come_one_by_one() {
    let server = server();
    let body = json!({"domain": plate(0.5)}).to_string();
    let answer = server.ask("POST /api/answer?tab=a", body.as_bytes());
    assert_eq!(answer.status, 200, "{}", answer.head);
    let text = String::from_utf8(answer.body).unwrap();
    let lines: Vec<Value> = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(lines[0]["kind"], "domain");
    assert_eq!(lines.last().unwrap()["kind"], "done");
}

/// An answer that takes many seconds: exact work on 4000 vertices.
fn long_work() -> Vec<u8> {
    json!({"domain": plate(0.0035), "goal": {"keep_angle": 1.0}, "show": ["wanted"]})
        .to_string()
        .into_bytes()
}

/// Less than the time limit of an answer, which would end the long work, too.
const SOON: Duration = Duration::from_secs(45);

/// Reads until the first mesh has come.
fn until_first_mesh(stream: &mut TcpStream) {
    let mut all = Vec::new();
    let mut some = vec![0; 1 << 16];
    while !String::from_utf8_lossy(&all).contains("\"kind\":\"mesh\"") {
        let count = stream.read(&mut some).unwrap();
        assert!(count > 0, "the answer ended: {}", String::from_utf8_lossy(&all));
        all.extend_from_slice(&some[..count]);
    }
}

#[test]
fn a_newer_request_of_a_tab_ends_the_older_and_no_other() {
    let server = server();
    let token = ("X-Mindeg-Token", server.token.as_str());
    let start = |tab: &str| {
        let mut stream = server.connect();
        let line = format!("POST /api/answer?tab={tab}");
        stream.write_all(&server.bytes(&line, &[token], &long_work())).unwrap();
        until_first_mesh(&mut stream);
        stream
    };
    let started = Instant::now();
    let (mut first, mut other) = (start("a"), start("b"));
    let body = json!({"domain": plate(0.5), "show": ["wanted"]}).to_string();
    // Both turns are taken: this one gets a turn because the older answer of its tab ends.
    let quick = server.ask("POST /api/answer?tab=a", body.as_bytes());
    assert!(String::from_utf8_lossy(&quick.body).contains("\"kind\":\"done\""));
    // It ends without a word: neither is it done, nor did it take too long.
    let ended = String::from_utf8_lossy(&what_is_left(&mut first)).into_owned();
    assert!(!ended.contains("\"kind\":\"done\"") && !ended.contains("\"kind\":\"refused\""));
    assert!(started.elapsed() < SOON, "{:?}", started.elapsed());
    other.set_read_timeout(Some(Duration::from_millis(300))).unwrap();
    let mut rest = Vec::new();
    let error = other.read_to_end(&mut rest).unwrap_err();
    assert!(matches!(error.kind(), ErrorKind::WouldBlock | ErrorKind::TimedOut), "{error}");
}

#[test]
fn a_closed_connection_gives_its_turn_to_others() {
    let server = server();
    let token = ("X-Mindeg-Token", server.token.as_str());
    let start = Instant::now();
    for tab in ["a", "b", "c", "d"] {
        let mut stream = server.connect();
        let line = format!("POST /api/answer?tab={tab}");
        stream.write_all(&server.bytes(&line, &[token], &long_work())).unwrap();
        until_first_mesh(&mut stream);
        // Dropped: the fifth would wait for minutes otherwise.
    }
    let body = json!({"domain": plate(0.5), "show": ["wanted"]}).to_string();
    let quick = server.ask("POST /api/answer?tab=e", body.as_bytes());
    assert!(String::from_utf8_lossy(&quick.body).contains("\"kind\":\"done\""));
    assert!(start.elapsed() < SOON, "{:?}", start.elapsed());
}

#[test]
fn states_come_back() {
    let server = server();
    assert_eq!(server.ask("GET /api/state/a", b"").status, 404);
    let state = br#"{"domain": {}, "goal": "least_degree"}"#;
    assert_eq!(server.ask("PUT /api/state/a", state).status, 204);
    assert_eq!(server.ask("GET /api/state/a", b"").body, state);
    for id in 0..32 {
        assert_eq!(server.ask(&format!("PUT /api/state/{id}"), b"1").status, 204);
    }
    assert_eq!(server.ask("GET /api/state/a", b"").status, 404);
    assert_eq!(server.ask("GET /api/state/31", b"").status, 200);
}

#[test]
fn every_format_is_downloaded_and_read_back() {
    let server = server();
    let facts = server.ask("GET /api/facts", b"").json();
    let body = json!({"domain": plate(0.5), "goal": {"keep_angle": 0.95}}).to_string();
    let formats = facts["formats"].as_array().unwrap();
    assert!(formats.len() >= 16, "{formats:?}");
    for format in formats {
        let name = format["name"].as_str().unwrap();
        let files: Vec<(String, Vec<u8>)> = (0..format["files"].as_array().unwrap().len())
            .map(|file| {
                let line = format!("POST /api/download?format={name}&file={file}");
                let answer = server.ask(&line, body.as_bytes());
                assert_eq!(answer.status, 200, "{name}: {}", answer.head);
                let extension = format["files"][file].as_str().unwrap();
                // The goal is in the name, so that files of two goals do not meet.
                let path = format!("plate-keep-angle-95.{extension}");
                let expected = format!("filename=\"{path}\"");
                assert!(answer.head.contains(&expected), "{}", answer.head);
                (path, answer.body)
            })
            .collect();
        let path = std::path::Path::new(&files[0].0);
        let read_back = mindeg_formats::Format::READ.iter().any(|format| format.name() == name);
        if read_back {
            let beside = |other: &str| {
                let found = files.iter().find(|(name, _)| name == other);
                Ok(found.unwrap().1.clone())
            };
            let mesh = mindeg_formats::read(path, files[0].1.as_slice(), beside).unwrap();
            assert_eq!((mesh.positions().len(), mesh.triangles().len()), (28, 26), "{name}");
        }
    }
}

#[test]
fn files_of_other_programs_are_domains() {
    let server = server();
    let read = |name: &str, bytes: &[u8]| {
        let answer = server.ask(&format!("POST /api/read?name={name}"), bytes);
        (answer.status, answer.json())
    };
    let (_, sources) =
        read("a.wkt", b"MULTIPOLYGON(((0 0,4 0,4 3,0 3)),((9 9,10 9,10 10)),((0 0,4 4,4 0,0 4)))");
    let sources = sources.as_array().unwrap();
    // The whole map comes first. The third crosses itself, and is parted.
    let (whole, sources) = sources.split_first().unwrap();
    assert!(whole["map"].is_object(), "{whole}");
    assert!(sources.len() > 3 && sources.iter().all(|source| source["domain"].is_object()));
    let note = sources[0]["notes"][0].as_str().unwrap();
    assert!(note.contains("repaired"), "{note}");
    let body = json!({"domain": sources[0]["domain"], "show": ["degree"]}).to_string();
    let answer = server.ask("POST /api/answer?tab=a", body.as_bytes());
    assert!(String::from_utf8_lossy(&answer.body).contains("\"kind\":\"degree\""));
    let (status, answer) = read("a.json", plate(1.0).to_string().as_bytes());
    assert_eq!((status, &answer[0]["name"]), (200, &json!("plate")));
    for (name, bytes) in [("a.json", &b"{"[..]), ("a.svg", b"no"), ("a", b""), ("a.json", b"\xff")]
    {
        let (status, answer) = read(name, bytes);
        assert_eq!(status, 422, "{answer}");
        assert!(answer["message"].as_str().unwrap().starts_with(name), "{answer}");
    }
}
