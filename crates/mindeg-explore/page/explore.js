const [token] = location.hash.slice(1).split("/");
const headers = { "X-Mindeg-Token": token };
const start = await (await fetch("/api/start", { headers })).json();
document.querySelector("#status").textContent = start.name;
