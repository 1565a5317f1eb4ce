// SPDX-License-Identifier: Apache-2.0
// The WebAssembly module (try.cpp): texts in, JSON lines out. It has no files and no clock; of a system it gets one thing,
// a place to say why it gives up.
const NOT_THERE = 52; // of WASI: no such call

export class Engine {
  // `bytes`: of the module.
  constructor(bytes) {
    this.module = new WebAssembly.Module(bytes);
    this.start();
  }

  start() {
    this.said = '';
    const calls = {
      fd_write: (file, parts, count, written) => this.say(parts, count, written),
      environ_sizes_get: (...to) => this.nothing(to),
      environ_get: () => 0,
      proc_exit: (status) => {
        throw new Error(`ended with status ${status}`);
      },
    };
    const imports = {};
    for (const { module, name } of WebAssembly.Module.imports(this.module))
      (imports[module] ??= {})[name] = calls[name] ?? (() => NOT_THERE);
    this.exports = new WebAssembly.Instance(this.module, imports).exports;
    this.exports._initialize();
  }

  get memory() {
    return new DataView(this.exports.memory.buffer);
  }

  nothing(places) {
    for (const place of places) this.memory.setUint32(place, 0, true);
    return 0;
  }

  say(parts, count, written) {
    const { memory } = this;
    let size = 0;
    for (let i = 0; i < count; ++i) {
      const at = memory.getUint32(parts + 8 * i, true);
      const length = memory.getUint32(parts + 8 * i + 4, true);
      this.said += new TextDecoder().decode(new Uint8Array(memory.buffer, at, length));
      size += length;
    }
    memory.setUint32(written, size, true);
    return 0;
  }

  // Lines of JSON. `options`: README.md. What ends the module itself is a line, too, and the next call finds it anew.
  run(program, setup, options = {}) {
    try {
      const texts = [program, setup, JSON.stringify(options)].map((text) => new TextEncoder().encode(text));
      const places = texts.map((text) => this.exports.malloc(text.length + 1));
      texts.forEach((text, i) => new Uint8Array(this.memory.buffer).set(text, places[i]));
      const at = this.exports.toolcomp_try(...texts.flatMap((text, i) => [places[i], text.length]));
      for (const place of places) this.exports.free(place);
      const all = new Uint8Array(this.memory.buffer);
      return new TextDecoder().decode(all.subarray(at, all.indexOf(0, at)));
    } catch (error) {
      const text = `internal error: ${this.said.trim() || error.message}`;
      this.start();
      return `${JSON.stringify({ kind: 'fault', in: 'toolcomp', text })}\n`;
    }
  }
}
