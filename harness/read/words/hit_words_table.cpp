#include "harness/read/words/hit_words_table.h"

namespace harness {
namespace {

constexpr MeaningRow table[] = {
    {Meaning::sphere, "sphere spheres ball sph", "kugel kugeln", "", "esfera esferas", "sfera sfere", "",
     "bol bal kula kule kuli sfery koule kouli kure kureye kureyi kurenin"},
    {Meaning::triangle, "triangle triangles tri", "dreieck dreiecks dreiecke", "", "triangulo triangulos",
     "triangolo triangoli", "",
     "driehoek trojkat trojkata trojkatem trojuhelnik trojuhelniku ucgen ucgene ucgeni ucgenin"},
    {Meaning::cylinder, "cylinder cylinders cyl", "zylinder zylinders", "cylindre cylindres", "cilindro cilindros",
     "cilindri", "", "cilinder walec walca walcem valec valce silindir silindire silindiri"},
    {Meaning::any_object, "object objects anything everything any both all others", "objekt objekte objekten alles",
     "objet objets tout tous autres", "objeto objetos todo todos otros", "oggetto oggetti tutto tutti altri",
     "tudo outros", "objecten obiekt obiektow nesne nesneye nesneler"},
    {Meaning::ray, "ray rays it we i they", "strahl er sie wir", "rayon il elle on nous", "rayo", "raggio", "raio ele",
     "straal promien paprsek isin"},
    {Meaning::hit,
     "hit hits hitting intersect intersects intersected intersecting intersection intersections touch touches touched "
     "meet meets met reach reaches reached strike strikes struck root roots solution solutions hitpoint",
     "treffer trifft treffen getroffen schnitt schnitte schnittpunkt schnittpunkte trefferpunkt schneidet schneiden "
     "geschnitten beruhrt beruhren losung losungen nullstelle nullstellen",
     "impact impacts touche touchent touchee coupe coupent rencontre atteint intersecte racine racines croise",
     "interseccion intersecciones impacto impactos impacta golpea golpeado toca tocan tocado corta interseca "
     "intersecta "
     "intersecan solucion soluciones raiz raices choca alcanza alcanzado",
     "intersezione intersezioni impatto colpisce colpito colpita tocca toccato soluzione soluzioni radice radici "
     "incontra",
     "intersecao intersecoes interseccao interseccoes atinge atingido atingida solucao solucoes raizes acerta "
     "acertado",
     "raakt geraakt snijdt snijpunt trefpunt trafia trafiony trafiona trafienie przecina uderza zasahne zasah protina "
     "carpar carpiyor vurur keser kesisir kesiyor isabet"},
    {Meaning::miss, "miss misses missed", "verfehlt verfehlen verpasst vorbei daneben", "manque manquee", "falla",
     "manca mancato mancata", "erra falha", "chybia omija iskalar"},
    {Meaning::negation,
     "no not never nor doesnt isnt dont didnt wasnt arent cannot cant wont without false neither fails fail",
     "nicht nie niemals nein ohne falsch weder", "pas ne non jamais sans faux ni", "nunca sin falso tampoco",
     "mai senza", "nao sem", "niet nie degil carpmaz kesmez vurmaz"},
    {Meaning::none, "none nothing null nil nullptr undefined n/a nonexistent nonexisting invalid",
     "nichts undefiniert kein keine keinen keinem keiner keines keins", "rien aucun aucune neant indefini indefinie",
     "ningun ninguno ninguna nada nulo nula indefinido indefinida", "niente nulla nessun nessuno nessuna indefinito",
     "nenhum nenhuma", "niets geen zaden zadnego zadny hicbiri hicbirine hicbir yok"},
    {Meaning::not_real, "complex imaginary", "komplex komplexe imaginar", "complexe complexes imaginaire imaginaires",
     "compleja complejas imaginaria imaginarias", "complesse immaginarie", "complexa complexas"},
    {Meaning::discriminant, "discriminant disc delta", "diskriminante", "", "discriminante", "", ""},
    {Meaning::negative, "negative", "negativ negativen", "negatif", "negativo negativa", "", ""},
    {Meaning::exists, "exist exists existent existing defined applicable available found possible valid",
     "existiert existieren definiert vorhanden reell gefunden moglich", "existe existent defini definie trouve reel",
     "existen definido definida encontrado", "esiste esistono definito definita trovato", "existem encontrada"},
    {Meaning::answer, "t normal normals value values point points parameter",
     "normale normalen wert werte punkt punkte normalenvektor", "normales valeur", "punto puntos valor",
     "punti valore valori", "ponto pontos"},
    {Meaning::link,
     "real positive such true find a an the single there is are was were be been has have had does do did of to "
     "with "
     "and "
     "actually even ever really actual common this that also at which belongs",
     "der die das den dem ein eine einen reelle reellen gemeinsamen gibt es ist sind wird hat einziger einzigen "
     "mit und gehort gehoert zum zur",
     "le la les l un une de d du y a est sont n reelle reelles avec et c",
     "el los las de hay se es son fue con "
     "real reales encontro",
     "lo gli di ci sono e ce ha viene si con una reali reale", "o os as ha com foi do da uma reais",
     "het van op przez jest"},
    {Meaning::partial,
     "cap caps tube side sides top bottom disk disks second third other another smaller "
     "double repeated plane yet more edge inside outside entry exit body lateral",
     "deckel mantel zweiter zweite anderer andere boden noch weiterer weitere ebene scheibe kappe kreisscheibe rohr "
     "deckflache grundflache",
     "autre deuxieme second plan couvercle disque chapeau bouchon",
     "otra otro segunda segundo tapa tapas disco cara plano circulo casquete tapon tubo manto",
     "altra altro seconda secondo base basi tappo coperchio disco faccia piano calotta cappuccio",
     "outra outro segunda tampa tampas topo fundo disco face plano cobertura"},
    {Meaning::passes, "pass passes passed goes flies", "", "passe", "", "", ""},
    {Meaning::by, "by past over above below under beside", "", "cote", "", "", ""},
    {Meaning::agent, "", "von vom durch", "par", "por", "dal dalla", "pelo pela"},
    {Meaning::first, "first", "zuerst erster erste erstes ersten erst", "premier premiere abord",
     "primero primera primer", "primo prima", "primeiro primeira",
     "eerst eerste najpierw pierwszy pierwsza pierwsze nejprve prvni ilk"},
    {Meaning::nearest, "closest nearest smallest least lowest minimum min earliest wins winner frontmost foremost",
     "nachste nachster nachstes nachsten kleinste kleinstes vorderste", "proche", "cercano cercana menor",
     "vicino vicina minore", "proximo proxima", "dichtstbij najblizszy najblizsza nejblizsi"},
    {Meaning::before,
     "before closer nearer earlier front less than ahead then beats occludes blocks hides covers obscures eclipses",
     "vor vorher naher fruher dann", "avant devant puis ensuite cache", "antes delante luego",
     "davanti poi nasconde copre", "frente esconde cobre"},
    {Meaning::covered, "occluded blocked hidden covered obscured", "verdeckt verborgen", "masque masquee",
     "tapado oculto oculta", "nascosto nascosta coperto", "escondido escondida coberto"},
    {Meaning::after, "after behind last later afterwards farthest", "nach hinter danach zuletzt dahinter",
     "apres derriere", "despues detras tras", "dopo dietro", "depois atras"},
    {Meaning::farther, "far farther further larger greater bigger", "weiter entfernter grosser", "loin", "lejos mayor",
     "lontano lontana maggiore", "longe maior"},
    {Meaning::tie, "tie tied simultaneously same equal", "gleichzeitig", "meme egalite", "empate igual", "pari uguale",
     ""},
    {Meaning::seen, "visible seen chosen see sees show shows", "sichtbar sieht sehen zeigt",
     "voit voient voyons montre", "ve ven veo vemos muestra", "visibile vede vedono vediamo mostra",
     "visivel veem mostra"},
    {Meaning::condition, "if when whether unless", "wenn falls ob", "quand", "cuando", "quando", ""},
    {Meaning::contrast, "but while whereas however", "sondern aber", "mais", "sino pero", "ma bensi", "mas"},
    {Meaning::reason, "since because", "weil denn", "car puisque parce", "porque pues", "perche poiche", "pois"},
    {Meaning::conclusion, "so thus hence therefore", "daher deshalb", "donc", "entonces", "quindi dunque",
     "portanto logo"},
    {Meaning::either, "or", "oder", "ou", "", "oppure", ""},
    {Meaning::debug, "debug dbg trace log", "", "", "", "", ""},
};

}  // namespace

std::span<const MeaningRow> hit_words_table() {
    return table;
}

}  // namespace harness
