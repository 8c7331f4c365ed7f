// Decodes depths and makes meshes of them beside the page, so that its pictures go on. Takes {id, codec, bytes, width,
// height, layout, focal, inverseNear, inverseFar, levels, maxTriangles, isBent, least}; answers {id, nearZ, mesh, seconds} or {id, problem}.
import {decodedDepth} from './depth_codec.js';
import {depthMesh} from './depth_mesh.js';
import {nearZOf} from './image_cover.js';

self.addEventListener('message', async ({data}) => {
  const {id, codec, bytes, width, height, levels} = data;
  const start = performance.now();
  try {
    const values = await decodedDepth(codec, bytes, width, height);
    if (values.some((value) => value > levels)) {
      throw new RangeError('a value is larger than "levels"');
    }
    const mesh = depthMesh({...data, values}, data);
    const nearZ = nearZOf({...data, values});
    const seconds = (performance.now() - start) / 1000;
    self.postMessage({id, nearZ, mesh, seconds}, [mesh.vertices.buffer, mesh.triangles.buffer, mesh.gaps.buffer]);
  } catch (error) {
    self.postMessage({id, problem: String(error.message ?? error)});
  }
});
