#lang racket/base
;; An interaction in a document: frames, computed beforehand.  A page moves through them; for LaTeX
;; there is the first.

(require "../interact/control.rkt" "../interact/interaction.rkt" "../interact/outcome.rkt"
         "../interact/outcome-picture-on-demand.rkt" "../interact/sampling.rkt"
         "../../error/computed-once.rkt" "../../error/message-words.rkt")

(provide interaction->shown shown-first coarser-shown shown-remarks at-start
         (struct-out shown-interaction) (struct-out axis)
         (struct-out shown-failure) (struct-out shown-drawing))

;; axes : of the controls, in their order; frames : vector of shown values, those of the last axis
;; next to each other; first : -> the first as a shown value for LaTeX
(struct shown-interaction (axes frames first) #:transparent)

;; name : text; kind : of the control; labels : vector of texts, of the values that are here;
;; start : position of the one at first; all : how many values the control has, #f of a text
(struct axis (name kind labels start all) #:transparent)

(struct shown-failure (text) #:transparent)
;; elements : of show/animation/svg.rkt
(struct shown-drawing (width height elements) #:transparent)

(define most-frames 60)

;; shown : value -> shown value
(define (interaction->shown i shown)
  (define controls (interaction-controls i))
  (define taken
    (sampled-positions (map count-of controls) (map start-of controls) most-frames))
  (define (frame values) (outcome->frame (interaction-outcome i values) shown))
  (shown-interaction
   (map make-axis controls taken)
   (for/vector ([values (in-list (combinations-of (map values-at controls taken)))])
     (frame values))
   (once (lambda () (outcome->shown ((interaction-first i)) shown)))))

(define (outcome->frame o shown)
  (define drawn (and (not (failed? o)) (outcome-elements o)))
  (if drawn (apply shown-drawing drawn) (outcome->shown o shown)))

(define (outcome->shown o shown)
  (if (failed? o) (shown-failure (failed-text o)) (shown o)))

;; ---------------------------------------------------------------------------
;; Axes

;; A text has one value on a page.
(define (values-of c) (or (control-values c) (vector (control-start c))))
(define (count-of c) (vector-length (values-of c)))
(define (start-of c) (if (control-values c) (control-position c (control-start c)) 0))
(define (values-at c positions) (for/list ([p (in-list positions)]) (vector-ref (values-of c) p)))

(define (make-axis c positions)
  (axis (symbol->string (control-name c)) (control-kind c)
        (for/vector ([v (in-list (values-at c positions))]) (value->label v))
        (for/first ([p (in-list positions)] [k (in-naturals)] #:when (= p (start-of c))) k)
        (and (control-values c) (count-of c))))

(define (axis-count a) (vector-length (axis-labels a)))

;; ((1 2) (a b)) -> ((1 a) (1 b) (2 a) (2 b))
(define (combinations-of lists)
  (if (null? lists)
      '(())
      (for*/list ([x (in-list (car lists))] [more (in-list (combinations-of (cdr lists)))])
        (cons x more))))

;; ---------------------------------------------------------------------------
;; Questions of a document

(define (shown-first s) ((shown-interaction-first s)))

;; "k = 1, n = 2"
(define (at-start s)
  (joined (for/list ([a (in-list (shown-interaction-axes s))])
            (format "~a = ~a" (axis-name a) (vector-ref (axis-labels a) (axis-start a))))))

;; The same with at most so many frames
(define (coarser-shown s most)
  (define axes (shown-interaction-axes s))
  (define counts (map axis-count axes))
  (define taken (sampled-positions counts (map axis-start axes) most))
  (define numbers (vector->list (list->numbers counts taken)))
  (struct-copy shown-interaction s
               [axes (map thinned axes taken)]
               [frames (for/vector ([k (in-list numbers)])
                         (vector-ref (shown-interaction-frames s) k))]))

;; -> the numbers of the frames at these positions
(define (list->numbers counts taken)
  (for/vector ([positions (in-list (combinations-of taken))])
    (for/fold ([number 0]) ([p (in-list positions)] [n (in-list counts)]) (+ p (* n number)))))

(define (thinned a positions)
  (struct-copy axis a
               [labels (for/vector ([p (in-list positions)]) (vector-ref (axis-labels a) p))]
               [start (for/first ([p (in-list positions)] [k (in-naturals)]
                                  #:when (= p (axis-start a)))
                        k)]))

;; -> texts: which values are not here
(define (shown-remarks s)
  (for*/list ([a (in-list (shown-interaction-axes s))]
              #:unless (equal? (axis-count a) (axis-all a)))
    (define n (axis-count a))
    (if (= n 1)
        (format "~a is fixed here" (axis-name a))
        (format "~a takes ~a of its ~a values here" (axis-name a) n (axis-all a)))))
