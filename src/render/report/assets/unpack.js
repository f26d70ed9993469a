// Takes the packed arrays of the page apart: base64, deflate, bytes sorted by weight, differences.

async function inflate(text) {
  const packed = Uint8Array.from(atob(text.trim()), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Reads arrays one behind the other.
class Arrays {
  constructor(bytes) {
    this.bytes = bytes;
    this.next = 0;
  }

  // 16-bit numbers.
  short(count) {
    const low = this.next;
    const high = low + count;
    this.next = high + count;
    const values = new Uint16Array(count);
    let value = 0;
    for (let i = 0; i < count; i++) {
      value = (value + this.bytes[low + i] + 256 * this.bytes[high + i]) & 0xffff;
      values[i] = value;
    }
    return values;
  }

  // Groups of `size` 32-bit numbers.
  groups(count, size) {
    const values = new Uint32Array(count * size);
    for (let corner = 0; corner < size; corner++) {
      const b = [0, 1, 2, 3].map((k) => this.next + k * count);
      this.next += 4 * count;
      let value = 0;
      for (let i = 0; i < count; i++) {
        const change = this.bytes[b[0] + i] | (this.bytes[b[1] + i] << 8) |
          (this.bytes[b[2] + i] << 16) | (this.bytes[b[3] + i] << 24);
        value = (value + change) | 0;
        values[i * size + corner] = value;
      }
    }
    return values;
  }
}
