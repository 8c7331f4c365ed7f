// Depths as the server sends them: the codecs of oc_core/image_codecs/image_codec.h that a browser can decode. Each gives
// a Uint16Array of the image's samples in rows from the top, and throws for bytes that are no such image.

/// The median edge detector of oc_core/image_codecs/depth_prediction.h.
function predicted(a, b, c) {
  const lower = Math.min(a, b);
  const upper = Math.max(a, b);
  return c >= upper ? lower : c <= lower ? upper : a + b - c;
}

export function depthFromResiduals(bytes, width, height) {
  const count = width * height;
  if (bytes.length !== 2 * count) {
    throw new RangeError(`there are ${bytes.length} bytes of depth, not ${2 * count}`);
  }
  const values = new Uint16Array(count);
  for (let y = 0, i = 0; y < height; ++y) {
    for (let x = 0; x < width; ++x, ++i) {
      const a = x > 0 ? values[i - 1] : 0;
      const b = y > 0 ? values[i - width] : 0;
      const c = x > 0 && y > 0 ? values[i - width - 1] : 0;
      const folded = bytes[i] << 8 | bytes[count + i];
      const rest = (folded & 1) === 0 ? folded >> 1 : -(folded >> 1) - 1;
      values[i] = predicted(a, b, c) + rest;
    }
  }
  return values;
}

/// No more than `size` bytes are inflated.
async function inflated(bytes, size) {
  const reader = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate')).getReader();
  const all = new Uint8Array(size);
  let filled = 0;
  for (let piece = await reader.read(); !piece.done; piece = await reader.read()) {
    if (filled + piece.value.length > size) {
      await reader.cancel();
      throw new RangeError('the depth is longer than its image');
    }
    all.set(piece.value, filled);
    filled += piece.value.length;
  }
  if (filled !== size) {
    throw new RangeError('the depth ends too early');
  }
  return all;
}

async function fromDeflate(bytes, width, height) {
  return depthFromResiduals(await inflated(bytes, 2 * width * height), width, height);
}

/// The red and green channels of an image that the browser decodes.
async function channels(bytes, type, width, height) {
  const bitmap = await createImageBitmap(new Blob([bytes], {type}), {colorSpaceConversion: 'none', premultiplyAlpha: 'none'});
  if (bitmap.width !== width || bitmap.height !== height) {
    throw new RangeError(`the depth is ${bitmap.width}x${bitmap.height}, not ${width}x${height}`);
  }
  const context = new OffscreenCanvas(width, height).getContext('2d', {willReadFrequently: true});
  context.drawImage(bitmap, 0, 0);
  bitmap.close();
  const {data} = context.getImageData(0, 0, width, height);
  return [0, 1].map((channel) => Uint8Array.from({length: width * height}, (_, i) => data[4 * i + channel]));
}

/// High byte in red, low byte in green.
async function fromPng(bytes, width, height) {
  const [high, low] = await channels(bytes, 'image/png', width, height);
  return Uint16Array.from(high, (value, i) => value << 8 | low[i]);
}

/// The same of residuals.
async function fromWebp(bytes, width, height) {
  const [high, low] = await channels(bytes, 'image/webp', width, height);
  const both = new Uint8Array(2 * width * height);
  both.set(high);
  both.set(low, high.length);
  return depthFromResiduals(both, width, height);
}

const kCodecs = {deflate: fromDeflate, png: fromPng, webp: fromWebp};

export const depthCodecNames = Object.keys(kCodecs);

export async function decodedDepth(codec, bytes, width, height) {
  if (!(codec in kCodecs)) {
    throw new RangeError(`this page decodes no depth in "${codec}", only in ${depthCodecNames.join(', ')}`);
  }
  return kCodecs[codec](bytes, width, height);
}
