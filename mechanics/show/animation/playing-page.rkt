#lang racket/base
;; An animation as a page of its own: every picture's elements, a style sheet and a script.
;; The page asks the network for nothing, and shows its first picture without a script.

(require json
         racket/file
         racket/flonum
         racket/list
         racket/math
         racket/runtime-path
         racket/string
         (only-in xml xexpr->string)
         "film.rkt" "page-data.rkt" "pict-recorder.rkt" "scenery.rkt" "shapes.rkt" "svg.rkt")

(provide make-page)

(define-runtime-path style-sheet "playing-page.css")
(define-runtime-path script "playing-page.js")

;; -> bytes
(define (make-page s)
  (define elements (make-numbering))
  (define looks (make-numbering))
  (define panels
    (for/list ([p (in-list (scenery-panels s))])
      (panel-data p (panel-frames p (film-schedule (scenery-film s)) elements))))
  (define (class-of look) (format "s~a" (number-of! looks look)))
  (define markup (for/list ([e (in-list (numbered elements))]) (element->markup e class-of)))
  (string->bytes/utf-8
   (page-text (film-title (scenery-film s))
              (string-append (file->string style-sheet) (look-rules looks))
              (for/list ([d (in-list panels)] [i (in-naturals)]) (panel-markup d i markup))
              (ormap (lambda (d) (pair? (panel-data-curves d))) panels)
              (- (schedule-count (film-schedule (scenery-film s))) 1)
              (motion->json s panels markup))))

;; frames : for each picture the numbers of its elements
(struct panel-data (panel frames))

(define (panel-data-curves d) ((panel-trails (panel-data-panel d))))

(define (panel-frames p when-taken elements)
  (for/list ([i (in-range (schedule-count when-taken))])
    (for/list ([e (in-list (record-pict ((panel-picture p) (schedule-time when-taken i))))])
      (number-of! elements e))))

;; ---------------------------------------------------------------------------
;; The page's parts

(define (look-rules looks)
  (string-append*
   (for/list ([l (in-list (numbered looks))] [i (in-naturals)])
     (format ".s~a{~a}\n" i (look->css l)))))

(define (panel-markup d i markup)
  (define p (panel-data-panel d))
  (define-values (width height) (values (panel-width p) (panel-height p)))
  (string-append
   (format "<svg viewBox=\"0 0 ~a ~a\" role=\"img\" aria-label=\"~a\">"
           (number->svg width) (number->svg height)
           (if (= i 0) "the mechanism" "the phase portrait"))
   (string-append*
    (for/list ([k (in-range (length (panel-data-curves d)))] [color (in-cycle (cdr accents))])
      (format "<polyline id=\"trail~a-~a\" class=\"trail\" stroke=\"rgb(~a)\"/>" i k
              (string-join (map number->string color) ","))))
   (format "<g id=\"panel~a\">" i)
   (string-append* (for/list ([k (in-list (first (panel-data-frames d)))]) (list-ref markup k)))
   "</g></svg>"))

(define (motion->json s panels markup)
  (define f (scenery-film s))
  (define when-taken (film-schedule f))
  (define last (- (schedule-count when-taken) 1))
  (define back
    (if (film-trail-time f)
        (exact-ceiling (* last (/ (film-trail-time f) (abs (schedule-span when-taken)))))
        (json-null)))
  (jsexpr->string
   (hasheq 'elements markup
           'panels (for/list ([d (in-list panels)])
                     (hasheq 'frames (panel-data-frames d)
                             'trails (map curve->list (panel-data-curves d))))
           'detail trail-detail
           'back back
           'times (list (schedule-start when-taken) (schedule-end when-taken))
           'rate (/ last (schedule-seconds when-taken)))))

;; To a tenth of a pixel.
(define (curve->list curve)
  (for/list ([x (in-flvector curve)])
    (if (< -1e6 x 1e6) (/ (exact-round (* 10 x)) 10.0) 0)))

(define (page-text title css panels trails? last json)
  (define name (xexpr->string title))
  (string-append
   "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
   "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
   "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
   "style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:\">\n"
   "<title>" name "</title>\n<style>\n" css "</style>\n</head>\n<body>\n<h1>" name "</h1>\n"
   "<div class=\"panels\">\n" (string-join panels "\n") "\n</div>\n"
   (controls trails? last)
   "<script id=\"motion\" type=\"application/json\">" (inside-script json) "</script>\n"
   "<script>\n" (file->string script) "</script>\n</body>\n</html>\n"))

(define (controls trails? last)
  (string-append
   "<div class=\"controls\" id=\"controls\" hidden>\n<button id=\"play\">Play</button>\n"
   (format "<input id=\"slider\" type=\"range\" max=\"~a\" value=\"0\" aria-label=\"time\">\n"
           last)
   "<output id=\"clock\"></output>\n<label>speed <select id=\"speed\">"
   (string-append*
    (for/list ([factor (in-list '("0.1" "0.25" "0.5" "1" "2" "4"))])
      (format "<option value=\"~a\"~a>× ~a</option>" factor
              (if (equal? factor "1") " selected" "") factor)))
   "</select></label>\n"
   (format "<label~a><input id=\"trails\" type=\"checkbox\" checked> trail</label>\n</div>\n"
           (if trails? "" " hidden"))))
