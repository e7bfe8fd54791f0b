// SPDX-License-Identifier: MIT
// node play.mjs CHROMIUM URL FOLDER: opens the page in headless Chromium, plays it, and puts pictures into FOLDER. Prints one JSON object
// a line: {said} of the console, {failed} of an exception or a file that did not load, {picture} of each picture that was taken.
// Chromium is told what to do by its DevTools protocol, over a WebSocket.
import { spawn } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';

const [, , chromium, url, folder] = process.argv;
const LIMIT = 540_000; // milliseconds, for everything
const SIZE = { width: 320, height: 180, deviceScaleFactor: 1, mobile: false };
const KEYS = { ArrowRight: 39, ' ': 32, s: 83 };
const CODES = { ' ': 'Space', s: 'KeyS' };
const OPTIONS = [
	'--headless=new', '--no-sandbox', '--no-first-run', '--disable-dev-shm-usage', '--mute-audio', '--remote-debugging-port=0',
	'--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--ignore-gpu-blocklist', 'about:blank',
];

const tell = (what) => console.log(JSON.stringify(what));
const profile = mkdtempSync(join(tmpdir(), 'grass_page_'));
const browser = spawn(chromium, [`--user-data-dir=${profile}`, ...OPTIONS], { stdio: ['ignore', 'ignore', 'pipe'] });

function end(code) {
	browser.removeAllListeners('exit');
	browser.kill('SIGKILL');
	browser.once('exit', () => {
		rmSync(profile, { recursive: true, force: true, maxRetries: 5, retryDelay: 200 });
		process.exit(code);
	});
}
setTimeout(() => { tell({ failed: `the page was not done after ${LIMIT / 1000} s` }); end(1); }, LIMIT);

// The address that Chromium prints when it listens.
const address = await new Promise((resolve) => {
	let words = '';
	browser.stderr.on('data', (more) => {
		words += more;
		const found = /DevTools listening on (ws:\/\/\S+)/.exec(words);
		if (found) resolve(new URL(found[1]));
	});
	browser.once('exit', (code) => { tell({ failed: `Chromium ended with code ${code}: ${words.slice(-1500)}` }); process.exit(1); });
});
const pages = await (await fetch(`http://${address.host}/json`)).json();
const socket = new WebSocket(pages.find((page) => page.type === 'page').webSocketDebuggerUrl);
await new Promise((resolve) => { socket.onopen = resolve; });

let asked = 0;
const answers = new Map();
const ask = (method, params = {}) => new Promise((resolve) => {
	answers.set(++asked, resolve);
	socket.send(JSON.stringify({ id: asked, method, params }));
});

const waiting = new Set();
// The next line of the page that `fits`.
const line = (fits) => new Promise((resolve) => { waiting.add({ fits, resolve }); });

function hear(text) {
	tell({ said: text });
	if (!text.startsWith('GrassField page: ')) return;
	const facts = JSON.parse(text.slice('GrassField page: '.length));
	for (const one of waiting) {
		if (one.fits(facts)) {
			waiting.delete(one);
			one.resolve(facts);
		}
	}
}

socket.onmessage = (event) => {
	const { id, result, method, params } = JSON.parse(event.data);
	if (id) {
		answers.get(id)?.(result);
		answers.delete(id);
	} else if (method === 'Runtime.consoleAPICalled') {
		for (const text of params.args.map((one) => one.value ?? one.description ?? '').join(' ').split('\n')) hear(text);
	} else if (method === 'Runtime.exceptionThrown') {
		tell({ failed: params.exceptionDetails.exception?.description ?? params.exceptionDetails.text });
	} else if (method === 'Log.entryAdded' && params.entry.level === 'error') {
		tell({ failed: `${params.entry.text} ${params.entry.url ?? ''}` });
	} else if (method === 'Inspector.targetCrashed') {
		tell({ failed: 'the page crashed' });
		end(1);
	}
};

async function picture(name) {
	const { data } = await ask('Page.captureScreenshot', { format: 'png' });
	writeFileSync(join(folder, `${name}.png`), Buffer.from(data, 'base64'));
	tell({ picture: name });
}

const key = (type, name) => ask('Input.dispatchKeyEvent', {
	type, key: name, code: CODES[name] ?? name, windowsVirtualKeyCode: KEYS[name], ...(type === 'keyDown' && name.length === 1 ? { text: name } : {}),
});
async function press(name) {
	await key('keyDown', name);
	await line(() => true);
	await key('keyUp', name);
}

for (const domain of ['Runtime', 'Log', 'Page', 'Inspector']) await ask(`${domain}.enable`);
await ask('Emulation.setDeviceMetricsOverride', SIZE);
const stood = line((facts) => facts.does === 'stands');
await ask('Page.navigate', { url });
await stood;
await picture('stands');
await press('s');
await line(() => true);
await picture('without_shadows');
await press('s');
await key('keyDown', 'ArrowRight');
const start = await line(() => true);
await line((facts) => facts.ball > start.ball + 0.7);
await picture('rolls');
await key('keyUp', 'ArrowRight');
await press(' ');
await line((facts) => facts.mown > 0);
await picture('mown');
end(0);
