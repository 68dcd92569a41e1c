// Serves the page as just built, in front of a tp100d that runs already:
// `node dev/proxy.mjs DAEMON_PORT [PORT]`.
import { createServer, request as ask } from 'node:http';
import { connect } from 'node:net';
import { readFile } from 'node:fs/promises';
import { extname, join } from 'node:path';

const dist = new URL('../dist/', import.meta.url).pathname;
const daemon = Number(process.argv[2] ?? 8765);
const port = Number(process.argv[3] ?? 8766);
const kTypes = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml', '.woff2': 'font/woff2', '.txt': 'text/plain' };
const own = (headers) => ({ ...headers, host: `127.0.0.1:${daemon}`, ...(headers.origin ? { origin: `http://127.0.0.1:${daemon}` } : {}) });

const server = createServer(async (request, response) => {
  const name = new URL(request.url, 'http://x').pathname.slice(1) || 'index.html';
  if (name in (await files())) {
    response.setHeader('Content-Type', kTypes[extname(name)] ?? 'application/octet-stream');
    response.end(await readFile(join(dist, name)));
    return;
  }
  const onward = ask({ port: daemon, path: request.url, method: request.method, headers: own(request.headers) }, (answer) => {
    response.writeHead(answer.statusCode, answer.headers);
    answer.pipe(response);
  });
  onward.on('error', () => response.writeHead(502).end());
  request.pipe(onward);
});

async function files() {
  const { readdir } = await import('node:fs/promises');
  return Object.fromEntries((await readdir(dist)).map((name) => [name, true]));
}

server.on('upgrade', (request, socket, head) => {
  const onward = connect(daemon, '127.0.0.1', () => {
    const headers = Object.entries(own(request.headers)).map(([name, value]) => `${name}: ${value}\r\n`);
    onward.write(`GET ${request.url} HTTP/1.1\r\n${headers.join('')}\r\n`);
    onward.write(head);
    socket.pipe(onward).pipe(socket);
  });
  for (const [one, other] of [[socket, onward], [onward, socket]]) {
    one.on('error', () => other.destroy());
    one.on('close', () => other.destroy());
  }
});
server.listen(port, '127.0.0.1', () => console.log(`http://127.0.0.1:${server.address().port}/ in front of ${daemon}`));
