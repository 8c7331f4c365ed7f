// Images as they come: their headers, the pieces of their colours and depths (docs/remote_protocol.md), and the
// decoding of both. `events` is told
//   colored(image)   its colours are there: `image.bitmap`; the page can turn and zoom in it
//   deepened(image)  its depth is there: `image.mesh`, `image.depths`; the eye can move
//   failed(text, sequence)  something is wrong with it, and it will not come; nor will others in its format
import {depthCodecNames} from './depth_codec.js';
import {Pinhole} from './view_math.js';

const kHeaderBytes = 12;
const kMaxSide = 16384;
const kMaxPlaneBytes = 1 << 28;
/// Images that may be under way or in decoding at once; older ones are given up.
const kMaxUnderWay = 4;

/// Of the formats of colours that browsers may have: each decides by itself whether it has `jxl`.
const kMediaTypes = {
  png: 'image/png', jpeg: 'image/jpeg', jpeg_baseline: 'image/jpeg', webp: 'image/webp', webp_lossless: 'image/webp', jxl: 'image/jxl',
};

/// Why images with these settings of a server cannot be shown in any browser; nothing where some can.
export function unreadableReason({color, depth}) {
  if (color !== undefined && kMediaTypes[color] === undefined) {
    return colorReason(color, 'no browser has it');
  }
  return depth === undefined || depthCodecNames.includes(depth) ? '' : depthReason(depth, 'browsers have no decoder for it');
}

function colorReason(codec, why) {
  return `This browser cannot decode the colours in ${codec} (${why}). ` +
    'Start the server with another "--color", such as webp or png.';
}

function depthReason(codec, why) {
  return `The depth in ${codec} cannot be decoded: ${why}. Start the server with "--depth deflate".`;
}

class Plane {
  constructor({codec, bytes}) {
    this.codec = codec;
    this.size = bytes;
    this.received = 0;
    this.bytes = new Uint8Array(bytes);
  }
  take(offset, piece) {
    if (offset !== this.received || offset + piece.length > this.size) {
      throw new RangeError('the pieces of an image do not fit together');
    }
    this.bytes.set(piece, offset);
    this.received += piece.length;
    return this.received === this.size;
  }
}

function checkHeader(header) {
  const [width, height] = header.size ?? [];
  const isSide = (n) => Number.isInteger(n) && n >= 1 && n <= kMaxSide;
  const isPlane = (plane) => Number.isInteger(plane?.bytes) && plane.bytes >= 0 && plane.bytes <= kMaxPlaneBytes;
  if (!isSide(width) || !isSide(height) || !isPlane(header.color) || (header.depth && !isPlane(header.depth))) {
    throw new RangeError('the header of an image is not one');
  }
}

export class ImageReceiver {
  constructor(events, maxTriangles) {
    this.events = events;
    this.maxTriangles = maxTriangles;
    this.underWay = new Map();  // by their ids, which a server gives out from 1 for each connection
    this.inDecoding = new Map();  // by numbers of their own
    this.decodings = 0;
    this.workerProblem = '';
    this.worker = new Worker(new URL('./depth_worker.js', import.meta.url), {type: 'module'});
    this.worker.addEventListener('message', ({data}) => this.takeDepth(data));
    this.worker.addEventListener('error', (event) => this.failWorker(event.message || 'its worker does not run'));
  }

  /// `mesh` says how its depths are to be joined: {isBent, least} of depthMesh().
  begin(header, seconds, mesh) {
    checkHeader(header);
    const image = {
      id: header.id,
      sequence: header.sequence,
      view: header.view,
      width: header.size[0],
      height: header.size[1],
      layout: {sampling: header.sampling ?? 'cubic', regions: header.regions ?? []},
      header,
      begun: seconds,
      meshOptions: mesh,
      isGivenUp: false,
      color: new Plane(header.color),
      depth: header.depth ? new Plane(header.depth) : null,
      nearZ: 0,
      mesh: null,
      bitmap: null,
    };
    this.underWay.set(image.id, image);
    while (this.underWay.size > kMaxUnderWay) {
      this.giveUp(this.underWay.values().next().value);
    }
    return image;
  }

  piece(buffer) {
    if (buffer.byteLength < kHeaderBytes) {
      throw new RangeError('a piece of an image is too short');
    }
    const head = new DataView(buffer, 0, kHeaderBytes);
    const image = this.underWay.get(head.getUint32(0, true));
    const plane = [image?.color, image?.depth][head.getUint8(4)];
    if (!plane) {
      return;  // of an image that was given up
    }
    if (!plane.take(head.getUint32(8, true), new Uint8Array(buffer, kHeaderBytes))) {
      return;
    }
    if (plane === image.color) {
      this.decodeColor(image);
    } else {
      this.decodeDepth(image);
    }
  }

  giveUp(image) {
    image.isGivenUp = true;
    this.underWay.delete(image.id);
  }

  async decodeColor(image) {
    const {codec, bytes} = image.color;
    try {
      const type = kMediaTypes[codec];
      if (type === undefined) {
        throw new RangeError('no browser has it');
      }
      const bitmap = await createImageBitmap(new Blob([bytes], {type}),
        {colorSpaceConversion: 'none', premultiplyAlpha: 'none'});
      if (bitmap.width !== image.width || bitmap.height !== image.height) {
        throw new RangeError(`it is ${bitmap.width}x${bitmap.height}, not ${image.width}x${image.height}`);
      }
      if (image.isGivenUp) {
        bitmap.close();
        return;
      }
      image.bitmap = bitmap;
    } catch (error) {
      if (!image.isGivenUp) {
        this.giveUp(image);
        this.events.failed(colorReason(codec, error.message), image.sequence);
      }
      return;
    }
    if (!image.isGivenUp) {
      this.events.colored(image);
      this.endWhereWhole(image);
    }
  }

  endWhereWhole(image) {
    if (image.bitmap !== null && (image.depth === null || image.mesh !== null)) {
      this.underWay.delete(image.id);
    }
  }

  decodeDepth(image) {
    const [width, height] = [image.width, image.height];
    const {inverse_near: inverseNear, inverse_far: inverseFar, levels, codec} = image.header.depth;
    const {focal} = new Pinhole(image.view, width, height);
    this.inDecoding.set(++this.decodings, image);
    if (this.workerProblem !== '') {
      this.failWorker(this.workerProblem);
      return;
    }
    this.worker.postMessage({id: this.decodings, codec, bytes: image.depth.bytes, width, height, layout: image.layout,
      focal, inverseNear, inverseFar, levels, maxTriangles: this.maxTriangles, ...image.meshOptions});
  }

  takeDepth({id, problem, depths, mesh, seconds}) {
    const image = this.inDecoding.get(id);
    this.inDecoding.delete(id);
    if (image === undefined || image.isGivenUp) {
      return;
    }
    if (problem !== undefined) {
      this.giveUp(image);
      this.events.failed(depthReason(image.depth.codec, problem), image.sequence);
      return;
    }
    Object.assign(image, {depths, nearZ: depths.nearZ, mesh, decodeSeconds: seconds});
    this.events.deepened(image);
    this.endWhereWhole(image);
  }

  /// What it was to decode will not come, nor what it is given from now on.
  failWorker(problem) {
    this.workerProblem = problem;
    const images = [...this.inDecoding.values()].filter((image) => !image.isGivenUp);
    this.inDecoding.clear();
    images.forEach((image) => this.giveUp(image));
    images.forEach((image) => this.events.failed(depthReason(image.depth.codec, problem), image.sequence));
  }

  /// Bytes of the images that are on their way: {received, size}.
  progress() {
    const images = [...this.underWay.values()].map(({color, depth}) => ({
      received: color.received + (depth?.received ?? 0), size: color.size + (depth?.size ?? 0),
    })).filter(({received, size}) => received < size);
    const sum = (field) => images.reduce((total, image) => total + image[field], 0);
    return {received: sum('received'), size: sum('size')};
  }

  forget() {
    [...this.underWay.values()].forEach((image) => this.giveUp(image));
  }
}
