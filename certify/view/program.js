// SPDX-License-Identifier: Apache-2.0
// The text of a program, line by line, and where its blocks stand in it.

const packed = (text) => text.replace(/\s+/g, '').toUpperCase();

export class Program {
  constructor(data) {
    this.lines = data.text.split('\n').map((line) => line.replace(/\r$/, ''));
    if (this.lines[this.lines.length - 1] === '') this.lines.pop();
    this.klartext = data.klartext;
    this.digits = data.digits;
    this.files = new Map(data.files ?? []);
    this.more = data.more;
    this.blocks = data.blocks;
    this.at = new Map(); // numbers of blocks by the line they begin in, in their order
    this.blocks.forEach((block, i) => {
      if (!this.at.has(block.line)) this.at.set(block.line, []);
      this.at.get(block.line).push(i);
    });
  }

  // The line behind the last one of a block.
  end(block) {
    let line = this.blocks[block].line;
    if (this.klartext) while (line < this.lines.length && this.lines[line - 1].trimEnd().endsWith('~')) ++line;
    return line + 1;
  }

  text(block) {
    return this.lines.slice(this.blocks[block].line - 1, this.end(block) - 1).join('\n');
  }

  // The block that a line belongs to, of those that run there the one nearest to `near`; of a line without any, the
  // block before it.
  blockAt(line, near) {
    for (let at = Math.min(line, this.lines.length); at > 0; --at) {
      const here = this.at.get(at);
      if (here) return here.reduce((best, i) => (Math.abs(i - near) < Math.abs(best - near) ? i : best));
    }
    return 0;
  }

  // "2nd of 3" for a block that runs more than once, or nothing.
  pass(block) {
    const runs = this.at.get(this.blocks[block].line);
    return runs.length > 1 ? `run ${runs.indexOf(block) + 1} of ${runs.length}` : '';
  }

  // Numbers of the blocks that a search finds: N50 and 50 ask for sequence numbers, 50 then for a line; else, and where
  // there is none, the text counts, without blanks and capitals.
  find(query) {
    const wanted = packed(query);
    if (!wanted) return [];
    const where = (holds) => this.blocks.map((_, i) => i).filter((i) => holds(this.blocks[i], i));
    const number = /^(N?)0*(\d+)$/.exec(wanted);
    if (number) {
      const byNumber = where((block) => block.n === Number(number[2]));
      if (byNumber.length) return byNumber;
      if (!number[1]) {
        const byLine = where((block) => block.line === Number(number[2]));
        if (byLine.length) return byLine;
      }
    }
    return where((_, i) => packed(this.text(i)).includes(wanted));
  }
}
