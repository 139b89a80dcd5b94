#lang racket/base
;; Laying an S-expression out on lines.
;;
;; A datum stays on one line if it fits.  Else it is broken after its head: a sum
;; or a tuple gets a line for each component, a product or any other
;; application fills its lines.  The text is bounded like that of `write-datum`:
;; after `print-limit` atoms it says how many it left out.

(require "../../algebra/expression/write.rkt")

(provide layout)

;; layout : datum width [column] -> string, whose first line starts at `column`
(define (layout d width [column 0])
  (define port (open-output-string))
  (emit (datum->item (cut-datum d)) column 0 width port)
  (get-output-string port))

;; ---------------------------------------------------------------------------
;; Measured

;; An item is the text of an atom or a block: items, and the width they take on
;; one line.
(struct block (items width))

(define (item-width i) (if (string? i) (string-length i) (block-width i)))

(define (make-block items)
  (block items
         (for/fold ([w (+ 1 (max 1 (length items)))]) ([i (in-list items)])
           (+ w (item-width i)))))

(define (datum->item d)
  (define (items xs)
    (cond [(null? xs) '()]
          [(pair? xs) (cons (datum->item (car xs)) (items (cdr xs)))]
          [else (list "." (datum->item xs))]))
  (if (pair? d) (make-block (items d)) (format "~s" d)))

;; ---------------------------------------------------------------------------
;; Lines

;; Columns below which breaking a line is no use: nesting is too deep.
(define least-room 8)

;; Write an item that starts at `column` and is followed by `closers`
;; parentheses; lines after the first are indented to suit.
(define (emit i column closers width port)
  (if (or (string? i)
          (<= (+ column (block-width i) closers) width)
          (< (- width column) least-room))
      (emit-flat i port)
      (emit-broken (block-items i) column closers width port)))

(define (emit-flat i port)
  (cond [(string? i) (write-string i port)]
        [else
         (write-string "(" port)
         (for ([item (in-list (block-items i))] [n (in-naturals)])
           (unless (eqv? n 0) (write-string " " port))
           (emit-flat item port))
         (write-string ")" port)]))

(define (emit-broken items column closers width port)
  (define head (car items))
  (define operands (cdr items))
  (write-string "(" port)
  (emit head (+ column 1) (if (null? operands) (+ closers 1) 0) width port)
  (unless (null? operands)
    (define indent (operand-column head column width))
    (if (= indent (+ column 1))
        (new-line indent port)
        (write-string " " port))
    (if (and (line-each? head) (not (andmap string? operands)))
        (emit-lines operands indent (+ closers 1) width port)
        (emit-filled operands indent (+ closers 1) width port)))
  (write-string ")" port))

;; Operands stand beside a short head, unless that leaves them too little room,
;; and below a long one.
(define (operand-column head column width)
  (define w (item-width head))
  (if (and (<= w 16) (<= (+ column w) (* 2/3 width)))
      (+ column 2 w)
      (+ column 1)))

(define (line-each? head)
  (member head '("+" "-" "/" "up" "down" "list" "matrix-by-rows")))

(define (new-line column port)
  (newline port)
  (write-string (make-string column #\space) port))

;; Each item on its own line.
(define (emit-lines items column closers width port)
  (define last? (null? (cdr items)))
  (emit (car items) column (if last? closers 0) width port)
  (unless last?
    (new-line column port)
    (emit-lines (cdr items) column closers width port)))

;; As many items on a line as fit; one that needs several lines has them alone.
(define (emit-filled items column closers width port)
  (let loop ([items items] [at column] [fresh? #t])
    (unless (null? items)
      (define after (if (null? (cdr items)) closers 0))
      (define start (if fresh? at (+ at 1)))
      (define end (+ start (item-width (car items))))
      (define fits? (<= (+ end after) width))
      (cond [(or fits? fresh?)
             (unless fresh? (write-string " " port))
             (emit (car items) start after width port)
             (loop (cdr items) (if fits? end width) #f)]
            [else
             (new-line column port)
             (loop items column #t)]))))
