// Requests to the server that opened this page. Its address ends in #TOKEN or #TOKEN/STATE.

const [token, state] = location.hash.slice(1).split("/");

export const headers = { "X-Mindeg-Token": token };
/** The name of the state to begin with, if the address has one. */
export const firstState = state || null;

/** The answer to a request; an error carries the server's sentence. */
async function ask(path, options = {}) {
  let response;
  try {
    response = await fetch(path, { headers, ...options });
  } catch {
    throw new Error("mindeg explore no longer answers: was it ended in its terminal? Start it again and open the address it prints.");
  }
  if (response.ok) return response;
  const { message } = await response.json().catch(() => ({}));
  throw new Error(message ?? `The server refused the request (${response.status}).`);
}

export const getJson = async (path) => (await ask(path)).json();

/** Why a domain is refused, as the answer's line says it; null if it is not. */
export async function refusal(domain) {
  const body = JSON.stringify({ domain, show: [] });
  const answer = await ask(`/api/answer?tab=${newName()}`, { method: "POST", body });
  const lines = (await answer.text()).split("\n").filter(Boolean).map((line) => JSON.parse(line));
  return lines.find(({ kind }) => kind === "refused") ?? null;
}

/** The domains in a file of any format that mindeg reads; with a size, in edges of that length. */
export async function readFile(file, size) {
  const body = await file.arrayBuffer();
  const query = new URLSearchParams({ name: file.name, ...(size ? { size } : {}) });
  return (await ask(`/api/read?${query}`, { method: "POST", body })).json();
}

/** The file of the surface that the page starts with. */
export async function startFile(name) {
  return new File([await (await ask("/api/start/file")).blob()], name);
}

/** The domain with all sides divided into edges of a length; one of a file is read anew, so that curves are divided. */
export async function divide(domain, size, origin) {
  if (!origin) return (await ask(`/api/divide?${new URLSearchParams({ size })}`, { method: "POST", body: JSON.stringify({ domain }) })).json();
  const [file, place] = origin;
  const sources = await (file ? readFile(file, size) : getJson(`/api/start/divided?${new URLSearchParams({ size })}`));
  const { domain: divided, message } = sources[place];
  if (!divided) throw new Error(message);
  return divided;
}

/** The boundary changed so that a mesh can have an angle, with edges of a length if `size` is one, moved by `within` at most. */
export async function condition(domain, angle, size, within) {
  const query = new URLSearchParams({ angle, ...(size > 0 ? { size } : {}), ...(within >= 0 ? { within } : {}) });
  return (await ask(`/api/condition?${query}`, { method: "POST", body: JSON.stringify({ domain }) })).json();
}

/** A file that is answered, under its name. */
async function namedBlob(response) {
  const named = response.headers.get("Content-Disposition")?.match(/filename="([^"]+)"/);
  return { blob: await response.blob(), name: named?.[1] ?? null };
}

/** One file of a mesh, as a blob. */
export async function download(request, format, view, file) {
  const path = `/api/download?format=${encodeURIComponent(format)}&view=${view}&file=${file}`;
  const response = await ask(path, { method: "POST", body: JSON.stringify(request) });
  return namedBlob(response);
}

const solidQuery = (file, change, more) => new URLSearchParams({ name: file.name, change, ...more });

/** The surface in a file after a change. */
export async function solid(file, change, more) {
  return (await ask(`/api/solid?${solidQuery(file, change, more)}`, { method: "POST", body: await file.arrayBuffer() })).json();
}

/** A file of it, as a blob. */
export async function solidFile(file, change, format, more) {
  const response = await ask(`/api/solid/file?${solidQuery(file, change, { format, ...more })}`, { method: "POST", body: await file.arrayBuffer() });
  return namedBlob(response);
}

/** Keeps a state and puts its name into the address. */
export async function keepState(name, value) {
  await ask(`/api/state/${name}`, { method: "PUT", body: JSON.stringify(value) });
  history.replaceState(null, "", `#${token}/${name}`);
}

export const newName = () => crypto.randomUUID();

/** The mesh of all parts of a map for a purpose; without one, for the advised one, with the advice. */
export async function whole(map, purpose) {
  const query = new URLSearchParams(purpose ? { purpose } : {});
  return (await ask(`/api/whole?${query}`, { method: "POST", body: JSON.stringify(map) })).json();
}

/** A file of it, as a blob. */
export async function wholeFile(map, purpose, format) {
  const response = await ask(`/api/whole/file?${new URLSearchParams({ purpose, format })}`, { method: "POST", body: JSON.stringify(map) });
  return namedBlob(response);
}
