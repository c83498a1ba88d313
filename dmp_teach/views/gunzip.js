/** Unpack bytes that Python has compressed. @param {ArrayBufferView | ArrayBuffer} value */
export async function gunzip(value) {
  const packed = new Blob([/** @type {BlobPart} */ (value)]);
  const stream = packed.stream().pipeThrough(new DecompressionStream("gzip"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
