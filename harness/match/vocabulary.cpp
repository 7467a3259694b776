#include "harness/match/vocabulary.h"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace harness {
namespace {

namespace item = reference::item;

/// The words of a text with blanks and line ends between them.
Vocabulary words_of(std::string_view text) {
    Vocabulary words;
    while (!text.empty()) {
        const std::string_view word = text.substr(0, text.find_first_of(" \n"));
        if (!word.empty()) words.emplace(word);
        text.remove_prefix(std::min(text.size(), word.size() + 1));
    }
    return words;
}

constexpr std::string_view hits =
    " hit hitpoint phit hitpos hitposition intersection intersectionpoint "
    "pointofintersection impact impactpoint pointofimpact";
constexpr std::string_view normals =
    " n normal surfacenormal unitnormal nhat normaln normalvector normalized normalised "
    "nnormalized nnormalised normalizedn normalisedn unitn nunit";
constexpr std::string_view discriminants = "d disc discriminant delta dis discr bb4ac b24ac bbac b2ac d' det";
constexpr std::string_view quadratic_as =
    "a quadraticcoefficient coefficientoft2 t2coefficient acoefficient "
    "coefficienta coeffa qa aq";
constexpr std::string_view quadratic_bs =
    "b linearcoefficient coefficientoft tcoefficient coeffoft tcoeff "
    "bcoefficient coefficientb coeffb qb b' bprime halfb bhalf";
constexpr std::string_view quadratic_cs =
    "c constant constantterm constantcoefficient ccoefficient coefficientc coeffc qc";
constexpr std::string_view roots =
    " t tval tvalue rayparameter rayparametert parametert thit rayt smallestt smallert "
    "tsmaller tmin tnear closestt nearestt minimumt smallerroot smallerpositiveroot";
constexpr std::string_view weak_points = "p point pos position location i";
constexpr std::string_view weak_roots =
    "t1 t0 t2 root root1 root2 roots distance lambda raydistance parameter tminus "
    "tplus solution";

std::string all(std::string_view words, std::string_view more) {
    return fmt::format("{} {}", words, more);
}

struct Row {
    reference::ItemId item;
    std::string names, weak, never;
};

/// Names of one letter come from the handout.
const std::vector<Row>& table() {
    static const std::vector<Row> rows = {
        {item::P_VCS,
         "pvcs pixelvcs pixelinvcs pvc vcs pixelinviewcoordinates pixelincameracoordinates pview pcam pcamera "
         "pixelview "
         "viewpixel pixelinview pixelviewspace pixelinviewspace pixelcamera pixelcameraspace pixelincameraspace",
         "p pixel point view camera viewcoordinates cameracoordinates", ""},
        {item::X_vcs, "xvcs x xaxis xbasis basisx vcsx xvector xcam xdir", "right u side s basis1 vx e1 ex", ""},
        {item::Y_vcs, "yvcs y yaxis ybasis basisy vcsy yvector ycam ydir", "up v trueup basis2 vy e2 ey", ""},
        {item::Z_vcs, "zvcs z zaxis zbasis basisz vcsz zvector zcam zdir", "w n forward back backward basis3 vz e3 ez",
         ""},
        {item::M_VCS_to_WCS,
         "mvcstowcs m mvcs2wcs vcstowcs mvcswcs matrix inverseview inverseviewmatrix inverseofview "
         "inverseoftheviewmatrix viewinverse inverseofviewmatrix minv vcs2wcs invview cameratoworld viewtoworld "
         "cameraworld viewworld inverse inversematrix itsinverse theinverse invm inversem minverse vinv viewinv "
         "viewmatrixinv viewmatinv inverseviewmat inverselookat lookatinverse vcswcs camtoworld c2w cam2world "
         "camera2world view2world",
         "transform",
         "viewmatrix viewmat lookatmatrix lookat glmlookat wcstovcs wcsvcs mwcstovcs worldtoview worldtocamera "
         "worldtocam "
         "worldcamera worldview w2c world2cam world2camera world2view"},
        {item::P_WCS,
         "pwcs pixelwcs pixelinwcs wcs pwc pixelinworldcoordinates pworld worldcoordinates s worldposition pixelworld "
         "worldpixel pixelinworld pixelworldspace pixelinworldspace",
         "p pixel point world position rayorigin raystart raystartingpoint originoftheray startoftheray", ""},
        {item::V,
         "v direction raydirection raydir unitv vhat dir vector unitvector d vwcs ray directionv vnormalized "
         "vnormalised "
         "normalizedv normalisedv normalized normalised",
         "unit", "rayorigin raystart raystarting raystartingpoint originoftheray startoftheray"},
        {item::sphere::a, std::string(quadratic_as), "alpha", ""},
        {item::sphere::b, std::string(quadratic_bs), "h b2 beta", ""},
        {item::sphere::c, std::string(quadratic_cs), "gamma", ""},
        {item::sphere::d, std::string(discriminants), "determinant radicand d4", ""},
        {item::sphere::t, all("ts tsphere parameter", roots), std::string(weak_roots), ""},
        {item::sphere::hit, all("ps psphere spherehit spherehitpoint sphereintersection", hits), all("pt", weak_points),
         ""},
        {item::sphere::normal, all("ns nsphere spherenormal normalofsphere normalofthesphere", normals), "norm", ""},
        {item::triangle::matrix,
         "a matrix matrixa amatrix m coefficientmatrix systemmatrix linearsystem system lhs mat leftside lefthandside "
         "thematrix",
         "equations augmented", ""},
        {item::triangle::rhs,
         "rhs b righthandside rightside right righthand bvector vectorb rhsvector constant rightvector",
         "vector d y sa solutionvector r", ""},
        {item::triangle::t, all("tt ttri ttriangle", roots), all("mu", weak_roots), ""},
        {item::triangle::u, "u uvalue barycentricu baryu", "beta", ""},
        {item::triangle::v, "v vvalue barycentricv baryv", "gamma", ""},
        {item::triangle::hit, all("pt ptri ptriangle trianglehit trianglehitpoint triangleintersection", hits),
         std::string(weak_points), ""},
        {item::triangle::normal, all("nt ntri ntriangle trianglenormal normaloftriangle normalofthetriangle", normals),
         "norm", ""},
        {item::cylinder::a, all("tubea atube acylinder acyl", quadratic_as), "", ""},
        {item::cylinder::b, all("tubeb btube bcylinder bcyl", quadratic_bs), "", ""},
        {item::cylinder::c, all("tubec ctube ccylinder ccyl", quadratic_cs), "", ""},
        {item::cylinder::d, all("dtube tubed dcylinder", discriminants), "determinant radicand d4", ""},
        {item::cylinder::t, all("tc tcyl tcylinder tfinal finalt cylindert", roots),
         all("ttube tubet tside tbody", weak_roots), ""},
        {item::cylinder::hit, all("pc pcyl pcylinder cylinderhit cylinderhitpoint cylinderintersection", hits),
         std::string(weak_points), ""},
        {item::cylinder::normal, all("nc ncyl ncylinder cylindernormal normalofcylinder normalofthecylinder", normals),
         "norm ntube tubenormal", ""},
        {item::first_object, "", "", ""},
    };
    return rows;
}

}  // namespace

const std::vector<Names>& names_of_items() {
    static const std::vector<Names> all_names = [] {
        std::vector<Names> names;
        for (const Row& row : table())
            names.push_back({row.item, words_of(row.names), words_of(row.weak), words_of(row.never)});
        return names;
    }();
    return all_names;
}

const Names& names_of(const reference::ItemSpec& item) {
    const auto& table = names_of_items();
    const auto names = std::find_if(table.begin(), table.end(), [&](const Names& n) { return n.item == item.id; });
    if (names == table.end()) throw std::logic_error(fmt::format("no names for the item \"{}\"", item.label));
    return *names;
}

const Vocabulary& fillers() {
    static const Vocabulary words = words_of(
        "the is of value values are for answer result my final so then get we and in at its computed equals equal to "
        "with "
        "also normalized normalised unit-length vec3 vec4 vector point unit length xyz");
    return words;
}

const Vocabulary& choices() {
    static const Vocabulary words =
        words_of("choose chose chosen take taken took pick picked use used using select selected");
    return words;
}

const Vocabulary& not_an_answer() {
    static const Vocabulary words = words_of(
        "before unnormalized unnormalised nonnormalized raw reduced reduction elimination echelon expected wrong old "
        "undivided errors warnings missing problems bugs would debug dbg trace log test check temp tmp checking verify "
        "verification sanity notes intermediate previous vertex corner book textbook calculator");
    return words;
}

const Vocabulary& given_by_the_scene() {
    static const Vocabulary words = words_of(
        "r radius r2 center centre eye lookat vup width height dx dy pdcs spherecenter sphereradius cameraposition "
        "epsilon eps time");
    return words;
}

}  // namespace harness
