#lang racket/base
;; An interaction on a page: its first frame, which is there without a script and on paper; and
;; with one its controls and all frames.  The common part of frames, such as axes, stands in the
;; page once.

(require json
         net/base64
         racket/file
         (only-in racket/list append-map remove-duplicates)
         racket/runtime-path
         racket/string
         "page-value.rkt" "shown-interaction.rkt"
         "../animation/page-data.rkt" "../animation/svg.rkt")

(provide interaction->xexpr interaction-script interaction-policy)

(define-runtime-path script "interaction.js")

(define (interaction-script) (file->string script))

;; -> the policy by which a page may run this script, and no other
(define (interaction-policy)
  (define digest (sha256-bytes (string->bytes/utf-8 (interaction-script))))
  (format "; script-src 'sha256-~a'" (base64-encode digest #"")))

;; ---------------------------------------------------------------------------

;; room : how many bytes there are for it; number : -> number of the next picture
(define (interaction->xexpr s number room)
  (define-values (fitting d) (within s number room))
  `(div ([class "interaction"])
        (div ([class "still"])
             ,(raw (frame-markup d (start-frame fitting)))
             (p ([class "note"]) ,(visible (string-append "at " (at-start fitting)))))
        (div ([class "controls"] [hidden "hidden"])
             ,@(map axis->xexpr (shown-interaction-axes fitting)))
        (div ([class "live"]))
        ,@(for/list ([text (in-list (shown-remarks fitting))])
            `(p ([class "note"]) ,(visible text)))
        (style ,(raw (data-style d)))
        (script ([type "application/json"]) ,(raw (inside-script (data->json fitting d))))))

;; -> the interaction with as many frames as there is room for, and their data
(define (within s number room)
  (define frames (shown-interaction-frames s))
  (define d (frames->data frames number))
  (define-values (n size) (values (vector-length frames) (data-size d)))
  (if (or (<= size room) (= n 1))
      (values s d)
      (within (coarser-shown s (max 1 (min (- n 1) (quotient (* n room) size)))) number room)))

;; Three cells of a row: the name, the control, and the text of the value where that does not tell
(define (axis->xexpr a)
  (define n (vector-length (axis-labels a)))
  (define number? (eq? (axis-kind a) 'number))
  `(label ([class "control"])
          (span ,(visible (axis-name a)))
          ,(if (= n 1) '(output) (input-xexpr a n))
          ,(if (and number? (> n 1)) '(output) '(span))))

(define (input-xexpr a n)
  (define (at-start? k) (= k (axis-start a)))
  (case (axis-kind a)
    [(boolean) `(input ([type "checkbox"] ,@(if (at-start? 1) '([checked "checked"]) '())))]
    [(choice)
     `(select ,@(for/list ([l (in-vector (axis-labels a))] [k (in-naturals)])
                  `(option ([value ,(number->string k)]
                            ,@(if (at-start? k) '([selected "selected"]) '()))
                           ,(visible l))))]
    [else
     `(input ([type "range"] [min "0"] [max ,(number->string (- n 1))]
              [value ,(number->string (axis-start a))]))]))

;; ---------------------------------------------------------------------------
;; Frames

;; elements : texts of markup; frames : vector of lists of their numbers; style : rules for classes
(struct data (elements frames style))

(define (frames->data frames number)
  (define name (number))
  (define-values (elements looks) (values (make-numbering) (make-numbering)))
  (define common? (common-elements frames))
  (define (class-of look) (format "i~a-~a" name (number-of! looks look)))
  (define numbers
    (for/vector ([f (in-vector frames)])
      (for/list ([text (in-list (frame->texts f common? class-of number))])
        (number-of! elements text))))
  (data (list->vector (numbered elements))
        numbers
        (string-append*
         (for/list ([l (in-list (numbered looks))])
           (format ".~a{~a}\n" (class-of l) (look->css l))))))

(define (frame->texts f common? class-of number)
  (cond [(shown-drawing? f) (drawing->texts f common? class-of)]
        [(shown-failure? f)
         (list (markup `(pre ([class "failure"]) ,(visible (shown-failure-text f)))))]
        [else (map markup (shown->xexprs f number))]))

(define (drawing->texts d common? class-of)
  (define-values (width height)
    (values (number->svg (shown-drawing-width d)) (number->svg (shown-drawing-height d))))
  (define lines (in-fewer-elements (shown-drawing-elements d) common?))
  `(,(format "<figure><svg class=\"drawing\" width=\"~a\" height=\"~a\" viewBox=\"0 0 ~a ~a\">"
             width height width height)
    ,@(for/list ([e (in-list lines)]) (element->markup e class-of))
    "</svg></figure>"))

;; -> is an element drawn in more than one frame?
(define (common-elements frames)
  (define counts (make-hash))
  (for* ([f (in-vector frames)] #:when (shown-drawing? f)
         [e (in-list (remove-duplicates (shown-drawing-elements f)))])
    (hash-update! counts e add1 0))
  (lambda (e) (> (hash-ref counts e) 1)))

;; Lines of one look that follow each other become one element, but for those in other frames, too.
(define (in-fewer-elements elements common?)
  (define (line-key e) (if (common? e) (gensym) (or (line-kind e) (gensym))))
  (append-map (lambda (run) (if (null? (cdr run)) run (list (joined-lines run))))
              (group-consecutive elements line-key)))

(define (group-consecutive xs key)
  (define groups
    (for/fold ([groups '()] [last #f] #:result groups) ([x (in-list xs)])
      (define k (key x))
      (if (equal? k last)
          (values (cons (cons x (car groups)) (cdr groups)) k)
          (values (cons (list x) groups) k))))
  (reverse (map reverse groups)))

(define (data-size d)
  (+ (string-length (data-style d))
     (for/sum ([text (in-vector (data-elements d))]) (string-utf-8-length text))
     (for/sum ([f (in-vector (data-frames d))]) (* 4 (length f)))))

(define (frame-markup d frame)
  (string-append*
   (for/list ([k (in-list (vector-ref (data-frames d) frame))]) (vector-ref (data-elements d) k))))

(define (start-frame s)
  (for/fold ([frame 0]) ([a (in-list (shown-interaction-axes s))])
    (+ (axis-start a) (* frame (vector-length (axis-labels a))))))

(define (data->json s d)
  (jsexpr->string
   (hasheq 'elements (vector->list (data-elements d))
           'frames (vector->list (data-frames d))
           'labels (for/list ([a (in-list (shown-interaction-axes s))])
                     (map visible (vector->list (axis-labels a)))))))
