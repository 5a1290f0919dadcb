#include "organ/openmesh_reader.h"

#include <OpenMesh/Core/IO/importer/BaseImporter.hh>
#include <OpenMesh/Core/IO/reader/OFFReader.hh>
#include <OpenMesh/Core/System/omstream.hh>
#include <mutex>
#include <sstream>

namespace lapfx::organ {

namespace {

using namespace OpenMesh;  // NOLINT: the interface below uses its names
using OpenMesh::Attributes::StatusInfo;

/// Records what a reader reports. Half-edges, and colours and normals of faces, are not used here.
class Collector : public IO::BaseImporter {
  public:
    explicit Collector(Soup& soup) : soup_(soup) {}

    VertexHandle add_vertex(const Vec3f& p) override {
        soup_.positions.emplace_back(p[0], p[1], p[2]);
        return VertexHandle(static_cast<int>(soup_.positions.size()) - 1);
    }
    VertexHandle add_vertex() override { return add_vertex(Vec3f(0, 0, 0)); }
    void set_point(VertexHandle v, const Vec3f& p) override {
        if (known(v)) soup_.positions[index(v)] = {p[0], p[1], p[2]};
    }

    FaceHandle add_face(const VHandles& vertices) override {
        if (vertices.size() < 3) {
            soup_.add_unreadable(vertices.size());
            return FaceHandle();
        }
        for (const VertexHandle v : vertices) soup_.corners.push_back(static_cast<std::uint32_t>(v.idx()));
        soup_.first.push_back(static_cast<std::uint32_t>(soup_.corners.size()));
        return FaceHandle(static_cast<int>(soup_.faces()) - 1);
    }

    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec2f>& uvs) override {
        // Called right after add_face(). A list of another length cannot be matched to the corners.
        const std::size_t end = soup_.corners.size(), begin = soup_.first[soup_.faces() - 1];
        if (uvs.size() != end - begin) return;
        soup_.corner_uvs.resize(end, glm::vec2(no_uv, 0.0f));
        for (std::size_t i = 0; i < uvs.size(); ++i) soup_.corner_uvs[begin + i] = {uvs[i][0], uvs[i][1]};
    }

    void set_normal(VertexHandle v, const Vec3f& n) override {
        if (!known(v)) return;
        if (soup_.normals.size() < soup_.positions.size()) {
            soup_.normals.resize(soup_.positions.size(), glm::vec3(0.0f));
            hard_.resize(soup_.positions.size(), 0);
        }
        glm::vec3& there = soup_.normals[index(v)];
        const glm::vec3 normal(n[0], n[1], n[2]);
        // Two normals at one vertex mean a hard edge or a bad exporter. An organ gets a smooth normal instead.
        const bool differs = there != glm::vec3(0.0f) && glm::dot(there, normal) < 0.9f * glm::dot(there, there);
        if (differs) hard_[index(v)] = 1;
        there = normal;
    }
    void set_normal(VertexHandle v, const Vec3d& n) override { set_normal(v, Vec3f(n)); }

    void set_color(VertexHandle v, const Vec4f& c) override {
        if (!known(v)) return;
        soup_.colors.resize(soup_.positions.size(), glm::vec4(1.0f));
        soup_.colors[index(v)] = {c[0], c[1], c[2], c[3]};
    }
    void set_color(VertexHandle v, const Vec3f& c) override { set_color(v, Vec4f(c[0], c[1], c[2], 1.0f)); }
    void set_color(VertexHandle v, const Vec3uc& c) override { set_color(v, Vec3f(c) / 255.0f); }
    void set_color(VertexHandle v, const Vec4uc& c) override { set_color(v, Vec4f(c) / 255.0f); }

    void set_texcoord(VertexHandle v, const Vec2f& uv) override {
        if (!known(v)) return;
        soup_.uvs.resize(soup_.positions.size(), glm::vec2(0.0f));
        soup_.uvs[index(v)] = {uv[0], uv[1]};
    }

    std::size_t n_vertices() const override { return soup_.positions.size(); }
    std::size_t n_faces() const override { return soup_.faces(); }
    std::size_t n_edges() const override { return 0; }

    void finish_soup() {
        const std::size_t count = soup_.positions.size();
        for (std::size_t i = 0; i < hard_.size(); ++i)
            if (hard_[i]) soup_.normals[i] = glm::vec3(0.0f);
        if (!soup_.normals.empty()) soup_.normals.resize(count, glm::vec3(0.0f));
        if (!soup_.colors.empty()) soup_.colors.resize(count, glm::vec4(1.0f));
        if (!soup_.uvs.empty()) soup_.uvs.resize(count, glm::vec2(0.0f));
        if (!soup_.corner_uvs.empty()) soup_.corner_uvs.resize(soup_.corners.size(), glm::vec2(no_uv, 0.0f));
        for (glm::vec4& color : soup_.colors) color = linear_color(color);
    }

    // Members that no format here uses.
    HalfedgeHandle add_edge(VertexHandle, VertexHandle) override { return HalfedgeHandle(); }
    FaceHandle add_face(HalfedgeHandle) override { return FaceHandle(); }
    void add_face_texcoords(FaceHandle, VertexHandle, const std::vector<Vec3f>&) override {}
    void set_face_texindex(FaceHandle, int) override {}
    void set_halfedge(VertexHandle, HalfedgeHandle) override {}
    void set_status(VertexHandle, const StatusInfo&) override {}
    void set_next(HalfedgeHandle, HalfedgeHandle) override {}
    void set_face(HalfedgeHandle, FaceHandle) override {}
    void request_face_texcoords2D() override {}
    void set_texcoord(HalfedgeHandle, const Vec2f&) override {}
    void set_texcoord(VertexHandle, const Vec3f&) override {}
    void set_texcoord(HalfedgeHandle, const Vec3f&) override {}
    void set_status(HalfedgeHandle, const StatusInfo&) override {}
    void set_color(EdgeHandle, const Vec3uc&) override {}
    void set_color(EdgeHandle, const Vec4uc&) override {}
    void set_color(EdgeHandle, const Vec3f&) override {}
    void set_color(EdgeHandle, const Vec4f&) override {}
    void set_status(EdgeHandle, const StatusInfo&) override {}
    void set_normal(FaceHandle, const Vec3f&) override {}
    void set_normal(FaceHandle, const Vec3d&) override {}
    void set_color(FaceHandle, const Vec3uc&) override {}
    void set_color(FaceHandle, const Vec4uc&) override {}
    void set_color(FaceHandle, const Vec3f&) override {}
    void set_color(FaceHandle, const Vec4f&) override {}
    void set_status(FaceHandle, const StatusInfo&) override {}
    void add_texture_information(int, std::string) override {}

  private:
    static std::size_t index(VertexHandle v) { return static_cast<std::size_t>(v.idx()); }
    bool known(VertexHandle v) const { return v.idx() >= 0 && index(v) < soup_.positions.size(); }

    Soup& soup_;
    std::vector<char> hard_;  ///< vertices with normals that contradict each other
};

}  // namespace

bool read_off_with_openmesh(const std::string& text, Soup& soup) {
    static std::mutex one_at_a_time;
    const std::lock_guard lock(one_at_a_time);
    omerr().disable();
    omlog().disable();
    std::istringstream in(text, std::ios::binary);
    // Its loops trust the counts of the header, so a failed read has to end them.
    in.exceptions(std::ios::failbit | std::ios::badbit);
    Collector collector(soup);
    IO::Options options;
    options += IO::Options::VertexNormal;
    options += IO::Options::VertexColor;
    options += IO::Options::VertexTexCoord;
    try {
        if (!IO::OFFReader().read(in, collector, options)) return false;
    } catch (const std::exception&) {
        return false;
    }
    collector.finish_soup();
    return true;
}

}  // namespace lapfx::organ
