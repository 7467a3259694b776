#include "harness/match/vocabulary.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>


namespace harness {
namespace {

namespace item = reference::item;

/// Adds the names that all hit points go by to `names`.
Vocabulary names_of_hit(Vocabulary names) {
    for (const char* name : {"hit",
                             "hitpoint",
                             "phit",
                             "hitpos",
                             "hitposition",
                             "intersection",
                             "intersectionpoint",
                             "pointofintersection",
                             "impact",
                             "impactpoint",
                             "pointofimpact",
                             "schnittpunkt",
                             "trefferpunkt",
                             "auftreffpunkt",
                             "pointd'intersection",
                             "pointd'impact",
                             "puntodeintersección",
                             "puntodeinterseccion",
                             "puntodeimpacto",
                             "puntodiintersezione",
                             "puntod'intersezione",
                             "puntodiimpatto",
                             "puntod'impatto",
                             "pontodeinterseção",
                             "pontodeintersecao",
                             "pontodeimpacto",
                             "punkttrafienia",
                             "punktprzecięcia",
                             "punktprzeciecia",
                             "snijpunt",
                             "raakpunt",
                             "kesişimnoktası",
                             "kesisimnoktasi",
                             "isabetnoktası",
                             "isabetnoktasi",
                             "průsečík",
                             "prusecik",
                             "träffpunkt",
                             "skärningspunkt"})
        names.emplace(name);
    return names;
}

/// Adds the names that both normals go by to `names`.
Vocabulary names_of_normal(Vocabulary names) {
    for (const char* name : {"n",
                             "normal",
                             "normale",
                             "normalenvektor",
                             "vecteurnormal",
                             "surfacenormal",
                             "unitnormal",
                             "nhat",
                             "normaln",
                             "normalvector",
                             "normalized",
                             "normalised",
                             "nnormalized",
                             "nnormalised",
                             "normalizedn",
                             "normalisedn",
                             "unitn",
                             "nunit",
                             "vettorenormale",
                             "vectornormal",
                             "vetornormal",
                             "normalna",
                             "wektornormalny",
                             "normaal",
                             "normaalvector",
                             "normala",
                             "normála",
                             "normali",
                             "yüzeynormali",
                             "yuzeynormali",
                             "normalvektor"})
        names.emplace(name);
    return names;
}

/// Adds the names that both discriminants go by to `names`.
Vocabulary names_of_discriminant(Vocabulary names) {
    for (const char* name : {"d", "disc", "discriminant", "delta", "dis", "discr", "bb4ac", "b24ac", "bbac", "b2ac",
                             "d'", "det", "diskriminante", "discriminante"})
        names.emplace(name);
    return names;
}

}  // namespace

const std::vector<Names>& names_of_items() {
    static const std::vector<Names> table = {
        {item::P_VCS,
         {"pvcs", "pixelvcs", "pixelinvcs", "pvc", "vcs", "pixelinviewcoordinates", "pixelincameracoordinates", "pview",
          "pcam", "pcamera", "pixelview", "viewpixel", "pixelinview", "pixelviewspace", "pixelinviewspace",
          "pixelcamera", "pixelcameraspace", "pixelincameraspace"},
         {"p", "pixel", "point", "view", "camera", "viewcoordinates", "cameracoordinates"}},
        {item::X_vcs,
         {"xvcs", "x", "xaxis", "xbasis", "basisx", "vcsx", "xvector", "xcam", "xdir"},
         {"right", "u", "side", "s", "basis1", "vx", "e1", "ex"}},
        {item::Y_vcs,
         {"yvcs", "y", "yaxis", "ybasis", "basisy", "vcsy", "yvector", "ycam", "ydir"},
         {"up", "v", "trueup", "basis2", "vy", "e2", "ey"}},
        {item::Z_vcs,
         {"zvcs", "z", "zaxis", "zbasis", "basisz", "vcsz", "zvector", "zcam", "zdir"},
         {"w", "n", "forward", "back", "backward", "basis3", "vz", "e3", "ez"}},
        {item::M_VCS_to_WCS,
         {"mvcstowcs",      "m",
          "mvcs2wcs",       "vcstowcs",
          "mvcswcs",        "matrix",
          "inverseview",    "inverseviewmatrix",
          "inverseofview",  "inverseoftheviewmatrix",
          "viewinverse",    "inverseofviewmatrix",
          "minv",           "vcs2wcs",
          "invview",        "cameratoworld",
          "viewtoworld",    "cameraworld",
          "viewworld",      "inverse",
          "inversematrix",  "itsinverse",
          "theinverse",     "invm",
          "inversem",       "minverse",
          "vinv",           "viewinv",
          "viewmatrixinv",  "viewmatinv",
          "inverseviewmat", "inverselookat",
          "lookatinverse",  "vcswcs",
          "camtoworld",     "c2w",
          "cam2world",      "camera2world",
          "view2world"},
         {"transform"},
         {"viewmatrix", "viewmat", "lookatmatrix", "lookat", "glmlookat", "wcstovcs", "wcsvcs", "mwcstovcs",
          "worldtoview", "worldtocamera", "worldtocam", "worldcamera", "worldview", "w2c", "world2cam", "world2camera",
          "world2view"}},
        {item::P_WCS,
         {"pwcs", "pixelwcs", "pixelinwcs", "wcs", "pwc", "pixelinworldcoordinates", "pworld", "worldcoordinates", "s",
          "worldposition", "pixelworld", "worldpixel", "pixelinworld", "pixelworldspace", "pixelinworldspace"},
         {"p", "pixel", "point", "world", "position", "rayorigin", "raystart", "raystartingpoint", "originoftheray",
          "startoftheray"}},
        {item::V,
         {"v",           "direction",      "raydirection", "raydir",     "unitv",      "vhat",
          "dir",         "vector",         "unitvector",   "d",          "vwcs",       "ray",
          "richtung",    "strahlrichtung", "dirección",    "direccion",  "directionv", "vnormalized",
          "vnormalised", "normalizedv",    "normalisedv",  "normalized", "normalised"},
         {"unit", "normalized", "normalised"},
         {"rayorigin", "raystart", "raystarting", "raystartingpoint", "originoftheray", "startoftheray"}},
        {item::sphere::a,
         {"a", "quadraticcoefficient", "coefficientoft2", "t2coefficient", "acoefficient", "coefficienta", "coeffa",
          "qa", "aq"},
         {"alpha"}},
        {item::sphere::b,
         {"b", "linearcoefficient", "coefficientoft", "tcoefficient", "coeffoft", "tcoeff", "bcoefficient",
          "coefficientb", "coeffb", "b'", "bprime", "halfb", "bhalf", "qb"},
         {"h", "b2", "beta"}},
        {item::sphere::c,
         {"c", "constant", "constantterm", "constantcoefficient", "ccoefficient", "coefficientc", "coeffc", "qc"},
         {"gamma"}},
        {item::sphere::d, names_of_discriminant({}), {"determinant", "radicand", "d4"}},
        {item::sphere::t,
         {"t", "ts", "tsphere", "tval", "tvalue", "rayparameter", "rayparametert", "parametert", "parameter", "thit",
          "smallert", "tsmaller", "tmin", "tnear", "smallestt", "smallerroot", "smallerpositiveroot", "rayt"},
         {"t1", "t0", "t2", "root", "root1", "root2", "roots", "distance", "lambda", "raydistance", "tminus", "tplus",
          "solution"}},
        {item::sphere::hit,
         names_of_hit({"ps", "psphere", "spherehit", "spherehitpoint", "sphereintersection"}),
         {"p", "point", "pos", "position", "location", "i", "pt"}},
        {item::sphere::normal,
         names_of_normal({"ns", "nsphere", "spherenormal", "normalofsphere", "normalofthesphere"}),
         {"norm"}},
        {item::triangle::matrix,
         {"a", "matrix", "matrixa", "amatrix", "m", "coefficientmatrix", "systemmatrix", "linearsystem", "system",
          "lhs", "mat", "leftside", "lefthandside", "thematrix"},
         {"equations", "augmented"}},
        {item::triangle::rhs,
         {"rhs", "b", "righthandside", "rightside", "right", "righthand", "bvector", "vectorb", "rhsvector", "constant",
          "rightvector", "rechteseite", "ladoderecho", "secondmembre", "membrededroite"},
         {"vector", "d", "y", "sa", "solutionvector", "r"}},
        {item::triangle::t,
         {"t", "tt", "ttri", "ttriangle", "tval", "tvalue", "rayparameter", "parametert", "rayparametert", "thit",
          "rayt"},
         {"distance", "parameter", "t1", "lambda", "raydistance", "mu", "tminus", "tplus"}},
        {item::triangle::u, {"u", "uvalue", "barycentricu", "baryu"}, {"beta"}},
        {item::triangle::v, {"v", "vvalue", "barycentricv", "baryv"}, {"gamma"}},
        {item::triangle::hit,
         names_of_hit({"pt", "ptri", "ptriangle", "trianglehit", "trianglehitpoint", "triangleintersection"}),
         {"p", "point", "pos", "position", "location", "i"}},
        {item::triangle::normal,
         names_of_normal({"nt", "ntri", "ntriangle", "trianglenormal", "normaloftriangle", "normalofthetriangle"}),
         {"norm"}},
        {item::cylinder::a,
         {"a", "quadraticcoefficient", "coefficientoft2", "t2coefficient", "acoefficient", "coefficienta", "coeffa",
          "qa", "tubea", "atube", "acylinder", "acyl"},
         {}},
        {item::cylinder::b,
         {"b", "linearcoefficient", "coefficientoft", "tcoefficient", "coeffoft", "tcoeff", "bcoefficient",
          "coefficientb", "coeffb", "qb", "tubeb", "btube", "bcylinder", "bcyl", "halfb", "bprime"},
         {}},
        {item::cylinder::c,
         {"c", "constant", "constantterm", "constantcoefficient", "ccoefficient", "coefficientc", "coeffc", "qc",
          "tubec", "ctube", "ccylinder", "ccyl"},
         {}},
        {item::cylinder::d, names_of_discriminant({"dtube", "tubed", "dcylinder"}), {"determinant", "radicand", "d4"}},
        {item::cylinder::t,
         {"t",      "tc",     "tcyl",      "tcylinder", "tval", "tvalue", "rayparameter", "parametert", "rayparametert",
          "thit",   "rayt",   "smallestt", "smallert",  "tmin", "tnear",  "closestt",     "nearestt",   "minimumt",
          "tfinal", "finalt", "cylindert"},
         {"t1", "t0", "t2", "root", "roots", "distance", "lambda", "raydistance", "parameter", "ttube", "tubet",
          "tside", "tbody", "tminus", "tplus"}},
        {item::cylinder::hit,
         names_of_hit({"pc", "pcyl", "pcylinder", "cylinderhit", "cylinderhitpoint", "cylinderintersection"}),
         {"p", "point", "pos", "position", "location", "i"}},
        {item::cylinder::normal,
         names_of_normal({"nc", "ncyl", "ncylinder", "cylindernormal", "normalofcylinder", "normalofthecylinder"}),
         {"norm", "ntube", "tubenormal"}},
        {item::first_object, {}, {}},
    };
    return table;
}

const Names& names_of(const reference::ItemSpec& item) {
    const auto& table = names_of_items();
    const auto names = std::find_if(table.begin(), table.end(), [&](const Names& n) { return n.item == item.id; });
    if (names == table.end()) throw std::logic_error(fmt::format("no names for the item \"{}\"", item.label));
    return *names;
}

const Vocabulary& fillers() {
    static const Vocabulary words = {
        "the",  "is",       "of",     "value", "values", "are",        "for",        "answer",      "result",
        "my",   "final",    "so",     "then",  "get",    "we",         "and",        "in",          "at",
        "its",  "computed", "equals", "with",  "also",   "normalized", "normalised", "unit-length", "vec3",
        "vec4", "vector",   "point",  "unit",  "length", "xyz"};
    return words;
}

const Vocabulary& not_an_answer() {
    static const Vocabulary words = {"before",  "unnormalized", "unnormalised", "nonnormalized", "raw",
                                     "reduced", "reduction",    "elimination",  "echelon",       "expected",
                                     "wrong",   "old",          "undivided",    "errors",        "warnings",
                                     "missing", "problems",     "bugs",         "would"};
    return words;
}

const Vocabulary& words_of_a_log() {
    static const Vocabulary words = {"debug",    "dbg",          "trace",    "log",    "test",         "check",
                                     "temp",     "tmp",          "checking", "verify", "verification", "sanity",
                                     "notes",    "intermediate", "previous", "vertex", "corner",       "book",
                                     "textbook", "wolfram",      "matlab",   "numpy",  "calculator"};
    return words;
}

const Vocabulary& given_by_the_scene() {
    static const Vocabulary words = {"r",      "radius",       "r2",           "center",         "centre",  "eye",
                                     "lookat", "vup",          "width",        "height",         "dx",      "dy",
                                     "pdcs",   "spherecenter", "sphereradius", "cameraposition", "epsilon", "eps",
                                     "time"};
    return words;
}

}  // namespace harness
