#include "tests/scene/scene_file_samples.h"

#include <bit>
#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace ocelli::test {
namespace {

std::string bytesOf(uint64_t number, int count) {
  std::string bytes;
  for (int i = 0; i < count; ++i) {
    bytes += static_cast<char>(number >> (8 * i));
  }
  return bytes;
}

std::string word(int64_t number) {
  return bytesOf(static_cast<uint64_t>(number), 4);
}

std::string words(std::initializer_list<int64_t> numbers) {
  std::string bytes;
  for (const int64_t number : numbers) {
    bytes += word(number);
  }
  return bytes;
}

std::string shorts(std::initializer_list<int> numbers) {
  std::string bytes;
  for (const int number : numbers) {
    bytes += bytesOf(static_cast<uint64_t>(number), 2);
  }
  return bytes;
}

std::string floats(std::initializer_list<float> numbers) {
  std::string bytes;
  for (const float number : numbers) {
    bytes += bytesOf(std::bit_cast<uint32_t>(number), 4);
  }
  return bytes;
}

std::string bigEndian(uint32_t number) {
  const std::string bytes = word(number);
  return {bytes.rbegin(), bytes.rend()};
}

std::string bigEndianFloats(std::initializer_list<float> numbers) {
  std::string bytes;
  for (const float number : numbers) {
    bytes += bigEndian(std::bit_cast<uint32_t>(number));
  }
  return bytes;
}

std::string padded(std::string_view text, size_t size) {
  return std::string(text) + std::string(size - text.size(), '\0');
}

/// Quake 2. `triangles` and `vertices` are what the header says; there are one and three.
std::string md2(int64_t vertices, int64_t triangles, int64_t trianglesOffset, int64_t framesOffset) {
  const std::string header =
      "IDP2" + words({8, 64, 64, 52, 0, vertices, 3, triangles, 0, 1, 68, 68, trianglesOffset, framesOffset, 144, 144});
  const std::string coordinates = shorts({0, 0, 64, 0, 0, 64});
  const std::string triangle = shorts({0, 1, 2, 0, 1, 2});
  const std::string frame =
      floats({1, 1, 1, 0, 0, 0}) + padded("frame", 16) + std::string("\0\0\0\0\1\0\0\0\0\1\0\0", 12);
  return header + coordinates + triangle + frame;
}

/// Inter-Quake Model, version 2: one mesh, one vertex array of positions, one triangle.
std::string iqm(int64_t meshes, int64_t vertices, int64_t triangles, int64_t arraysOffset) {
  const std::string magic("INTERQUAKEMODEL\0", 16);
  const int64_t text = 124;
  const int64_t mesh = text + 8;
  const int64_t arrays = mesh + 24;
  const int64_t positions = arrays + 20;
  const int64_t corners = positions + 36;
  const std::string header = words({2,         corners + 12,
                                    0,         8,
                                    text,      meshes,
                                    mesh,      1,
                                    vertices,  arraysOffset < 0 ? arrays : arraysOffset,
                                    triangles, corners,
                                    0,         0,
                                    0,         0,
                                    0,         0,
                                    0,         0,
                                    0,         0,
                                    0,         0,
                                    0,         0,
                                    0});
  return magic + header + padded("", 8) + words({0, 0, 0, 3, 0, 1}) + words({0, 0, 7, 3, positions}) +
         floats({0, 0, 0, 1, 0, 0, 0, 1, 0}) + words({0, 1, 2});
}

/// GameStudio 7: the header, and one group that says it has so many triangles and vertices.
std::string mdl7(int64_t groups, int64_t triangles, int64_t vertices) {
  const std::string header =
      "MDL7" + words({7, 0, groups, 1000, 0, 0}) + shorts({32, 16, 16, 68, 8, 26, 26, 16, 4, 24});
  const std::string group =
      std::string("\1\0\0\0", 4) + word(500) + padded("group", 16) + words({0, 3, triangles, vertices, 1});
  return header + group + padded("", 200);
}

std::string quakeMdl(int64_t vertices, int64_t triangles, int64_t frames) {
  return "IDPO" + word(6) + floats({1, 1, 1, 0, 0, 0, 1, 0, 0, 0}) +
         words({1, 8, 8, vertices, triangles, frames, 0, 0, 0}) + padded("", 300);
}

std::string md5Mesh(const std::string& vertices, const std::string& triangles, const std::string& weights) {
  return "MD5Version 10\ncommandline \"\"\nnumJoints 1\nnumMeshes 1\njoints {\n  \"origin\" -1 ( 0 0 0 ) ( 0 0 0 )\n}\n"
         "mesh {\n  shader \"wood\"\n  numverts " +
         vertices + "\n  vert 0 ( 0 0 ) 0 1\n  vert 1 ( 1 0 ) 1 1\n  vert 2 ( 0 1 ) 2 1\n  numtris " + triangles +
         "\n  tri 0 0 1 2\n  numweights " + weights +
         "\n  weight 0 0 1 ( 0 0 0 )\n  weight 1 0 1 ( 1 0 0 )\n  weight 2 0 1 ( 0 1 0 )\n}\n";
}

std::string xText(const std::string& vertices, const std::string& faces, const std::string& corners) {
  return "xof 0303txt 0032\nMesh triangle {\n " + vertices + ";\n 0;0;0;,\n 1;0;0;,\n 0;1;0;;\n " + faces + ";\n 3;" +
         corners + ";;\n}\n";
}

std::string off(const std::string& counts) {
  return "OFF\n" + counts + "\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
}

std::string csm(const std::string& frames) {
  return "$Filename a.csm\n$Date 1\n$Time 1\n$Actor a\n$FirstFrame 1\n$LastFrame " + frames +
         "\n$Rate 60\n$Order A B\n$Points\n1 0 0 0 1 1 1\n2 0 0 1 1 1 2\n";
}

std::string lwo(uint32_t pointBytes) {
  const std::string points = "PNTS" + bigEndian(pointBytes) + bigEndianFloats({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const std::string face("FACE\0\3\0\0\0\1\0\2", 12);
  const std::string body = "LWO2TAGS" + bigEndian(2) + std::string("a\0", 2) + "LAYR" + bigEndian(18) + padded("", 18) +
                           points + "POLS" + bigEndian(static_cast<uint32_t>(face.size())) + face;
  return "FORM" + bigEndian(static_cast<uint32_t>(body.size())) + body;
}

std::string b3d(int64_t vertexBytes, int64_t corner) {
  const std::string vertices = "VRTS" + word(vertexBytes) + words({0, 0, 0}) + floats({0, 0, 0, 1, 0, 0, 0, 1, 0});
  const std::string triangles = "TRIS" + words({16, -1, 0, 1, corner});
  const std::string mesh = word(-1) + vertices + triangles;
  const std::string node = std::string("n\0", 2) + floats({0, 0, 0, 1, 1, 1, 1, 0, 0, 0}) + "MESH" +
                           word(static_cast<int64_t>(mesh.size())) + mesh;
  const std::string body = word(1) + "NODE" + word(static_cast<int64_t>(node.size())) + node;
  return "BB3D" + word(static_cast<int64_t>(body.size())) + body;
}

std::string binaryStl(int64_t triangles) {
  return padded("stl", 80) + word(triangles) + floats({0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0}) + shorts({0});
}

}  // namespace

std::vector<SceneFileSample> smallSceneFiles() {
  return {
      {"a.off", off("3 1 0")},
      {"a.raw", "# a triangle\n0 0 0 1 0 0 0 1 0\n0 0 1 1 0 1 0 1 1\n"},
      {"a.nff", "nff\nf 1 0 0 0.5 0.5 0 0 0\np 3\n0 0 0\n1 0 0\n0 1 0\n"},
      {"a.smd",
       "version 1\nnodes\n0 \"root\" -1\nend\nskeleton\ntime 0\n0 0 0 0 0 0 0\nend\ntriangles\nm.bmp\n"
       "0 0 0 0 0 0 1 0 0\n0 1 0 0 0 0 1 1 0\n0 0 1 0 0 0 1 0 1\nend\n"},
      {"a.ac",
       "AC3Db\nMATERIAL \"m\" rgb 1 0 0 amb 0 0 0 emis 0 0 0 spec 0 0 0 shi 10 trans 0\nOBJECT world\nkids 1\nOBJECT "
       "poly\n"
       "name \"a\"\nnumvert 3\n0 0 0\n1 0 0\n0 1 0\nnumsurf 1\nSURF 0x10\nmat 0\nrefs 3\n0 0 0\n1 0 0\n2 0 0\nkids "
       "0\n"},
      {"a.dxf",
       "0\nSECTION\n2\nENTITIES\n0\n3DFACE\n8\n0\n10\n0\n20\n0\n30\n0\n11\n1\n21\n0\n31\n0\n12\n0\n22\n1\n32\n0\n13\n0"
       "\n23\n1\n"
       "33\n0\n0\nENDSEC\n0\nEOF\n"},
      {"a.md2", md2(3, 1, 80, 92)},
      {"a.md5mesh", md5Mesh("3", "1", "3")},
      {"a.iqm", iqm(1, 3, 1, -1)},
      {"a.x", xText("3", "1", "0,1,2")},
      {"a.csm", csm("2")},
      {"a.mdl", quakeMdl(3, 1, 1)},
      {"b.mdl", mdl7(1, 1, 3)},
      {"a.lwo", lwo(36)},
      {"a.b3d", b3d(48, 2)},
      {"b.stl", binaryStl(1)},
      {"a.ms3d", "MS3D000000" + words({4}) + shorts({3}) + padded("", 200)},
      {"a.md3", "IDP3" + word(15) + padded("a", 64) + words({0, 1, 0, 1, 0, 108, 108, 164, 300}) + padded("", 200)},
      {"a.hmp", "HMP7" + words({7, 0, 0}) + padded("", 100)},
      {"a.ter", "TERRAGENTERRAIN SIZE" + shorts({4, 0}) + padded("ALTW", 80)},
      {"a.ndo", "nendo 1.1" + padded("", 100)},
      {"a.cob", "Caligari V00.01ALH             \n" + padded("", 100)},
      {"a.irr", "<?xml version=\"1.0\"?><irr_scene><node type=\"sphere\"></node></irr_scene>"},
      {"a.irrmesh",
       "<?xml version=\"1.0\"?><mesh><buffer><vertices type=\"standard\" vertexCount=\"3\">0 0 0 0 0 1 ffffffff 0 0\n"
       "1 0 0 0 0 1 ffffffff 1 0\n0 1 0 0 0 1 ffffffff 0 1\n</vertices><indices indexCount=\"3\">0 1 2</indices>"
       "</buffer></mesh>"},
      {"a.xgl",
       "<WORLD><MESH ID=\"0\"><P ID=\"0\">0,0,0</P><P ID=\"1\">1,0,0</P><P "
       "ID=\"2\">0,1,0</P><F><FV1><PREF>0</PREF></FV1>"
       "<FV2><PREF>1</PREF></FV2><FV3><PREF>2</PREF></FV3></F></MESH><OBJECT><MESHREF>0</MESHREF></OBJECT></WORLD>"},
      {"a.bvh",
       "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 3 Xposition Yposition Zposition\nEnd Site\n{\nOFFSET 0 1 0\n}\n}\n"
       "MOTION\nFrames: 1\nFrame Time: 0.1\n0 0 0\n"},
      {"a.ase",
       "*3DSMAX_ASCIIEXPORT 200\n*GEOMOBJECT {\n*NODE_NAME \"a\"\n*MESH {\n*MESH_NUMVERTEX 3\n*MESH_NUMFACES 1\n"
       "*MESH_VERTEX_LIST {\n*MESH_VERTEX 0 0 0 0\n*MESH_VERTEX 1 1 0 0\n*MESH_VERTEX 2 0 1 0\n}\n*MESH_FACE_LIST {\n"
       "*MESH_FACE 0: A: 0 B: 1 C: 2\n}\n}\n}\n"},
      {"a.blend", "BLENDER-v276" + padded("DNA1", 200)},
  };
}

std::vector<SceneFileSample> hostileSceneFiles() {
  constexpr int64_t kHuge = 0x7fffffff;
  constexpr int64_t kNegative = -16;
  return {
      {"memory.off", off("1000000000 100000000 0") + std::string(260, ' ')},
      {"faces.off", off("3 4000000000 0")},
      {"negative.off", off("-3 -1 0")},
      {"index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 400000000\n"},
      {"corners.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n"},
      {"vertices.md2", md2(kHuge, 1, 80, 92)},
      {"triangles.md2", md2(3, kHuge, 80, 92)},
      {"offset.md2", md2(3, 1, kHuge, 92)},
      {"negative.md2", md2(3, 1, kNegative, kNegative)},
      {"short.md2", md2(3, 1, 80, 92).substr(0, 90)},
      {"meshes.iqm", iqm(kHuge, 3, 1, -1)},
      {"vertices.iqm", iqm(1, kHuge, 1, -1)},
      {"triangles.iqm", iqm(1, 3, kHuge, -1)},
      {"offset.iqm", iqm(1, 3, 1, kHuge)},
      {"short.iqm", iqm(1, 3, 1, -1).substr(0, 140)},
      {"vertices.md5mesh", md5Mesh("4000000000", "1", "3")},
      {"triangles.md5mesh", md5Mesh("3", "4000000000", "3")},
      {"weights.md5mesh", md5Mesh("3", "1", "4000000000")},
      {"short.md5mesh", md5Mesh("3", "1", "3").substr(0, 150)},
      {"vertices.x", xText("4000000000", "1", "0,1,2")},
      {"faces.x", xText("3", "4000000000", "0,1,2")},
      {"index.x", xText("3", "1", "0,1,4000000000")},
      {"short.x", xText("3", "1", "0,1,2").substr(0, 60)},
      {"binary.x", "xof 0303bin 0032" + shorts({6}) + words({kHuge, kHuge, kHuge})},
      {"compressed.x", "xof 0303bzip0032" + words({kHuge}) + shorts({0x7fff, 0x4b43}) + padded("", 50)},
      {"frames.csm", csm("2000000000")},
      {"negative.csm", csm("-2000000000")},
      {"short.csm", "$Filename a.csm\n$Points"},
      {"groups.mdl", mdl7(kHuge, 1, 3)},
      {"triangles7.mdl", mdl7(1, kHuge, 3)},
      {"vertices7.mdl", mdl7(1, 1, kHuge)},
      {"vertices1.mdl", quakeMdl(kHuge, 1, 1)},
      {"triangles1.mdl", quakeMdl(3, kHuge, 1)},
      {"frames1.mdl", quakeMdl(3, 1, kHuge)},
      {"short.mdl", mdl7(1, 1, 3).substr(0, 40)},
      {"points.lwo", lwo(0x7ffffff0)},
      {"vertices.b3d", b3d(kHuge, 2)},
      {"index.b3d", b3d(48, kHuge)},
      {"triangles.stl", binaryStl(kHuge)},
      {"words.raw", "a b c d e f g h i\n"},
      {"short.raw", "0 0 0 1 0 0 0"},
      {"no_archive.3mf", "PK\3\4" + padded("", 100)},
      {"directory.3mf", "PK\5\6" + shorts({0, 0, 0x7fff, 0x7fff}) + words({kHuge, kHuge}) + shorts({0})},
      {"nested.gltf", std::string(200'000, '[')},
      {"buffer.gltf",
       R"({"asset": {"version": "2.0"}, "buffers": [{"byteLength": 9000000000000000000, "uri": "/dev/zero"}]})"},
      {"chunk.glb", "glTF" + words({2, kHuge, kHuge, 0x4e4f534a})},
      {"nested.dae", "<?xml version=\"1.0\"?><COLLADA version=\"1.4.1\">" +
                         [] {
                           std::string nodes;
                           for (int i = 0; i < 20'000; ++i) {
                             nodes += "<node>";
                           }
                           return nodes;
                         }()},
  };
}

}  // namespace ocelli::test
