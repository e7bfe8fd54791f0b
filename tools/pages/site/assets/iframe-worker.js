// SPDX-License-Identifier: MIT
// A page that is opened as a file may not start a worker, which the search runs in. There it runs in a hidden frame instead.
if (window.Worker && location.protocol === "file:") {
	window.Worker = class extends EventTarget {
		constructor(url) {
			super();
			this.frame = document.createElement("iframe");
			this.frame.hidden = true;
			document.body.append(this.frame);
			const inside = this.frame.contentWindow;
			inside.document.open();
			inside.document.write("<!doctype html><html><body></body></html>");
			inside.document.close();
			inside.postMessage = (data) => this.tell(data);
			inside.importScripts = (...urls) => urls.reduce((before, next) => before.then(() => this.load(next)), Promise.resolve());
			this.ready = this.load(url);
		}

		load(url) {
			return new Promise((resolve, reject) => {
				const script = this.frame.contentDocument.createElement("script");
				script.src = new URL(url, location.href);
				script.onload = resolve;
				script.onerror = reject;
				this.frame.contentDocument.body.append(script);
			});
		}

		tell(data) {
			const event = new MessageEvent("message", { data });
			this.dispatchEvent(event);
			this.onmessage?.(event);
		}

		postMessage(data) {
			this.ready.then(() => this.frame.contentWindow.dispatchEvent(new MessageEvent("message", { data })));
		}

		terminate() {
			this.frame.remove();
		}
	};
}
